// Mean and standard error of an estimate from independently randomised replicates.
//
// Points of one low-discrepancy sequence are not independent, so their own spread says nothing about the error of their
// mean. Instead every pixel is estimated kReplicates times, each time with the same number of points of a sequence of
// its own scrambling; the replicates are independent and have the same expectation, and their spread is the error.
// Channels are means of integrands; what is shown may be any function of these means (a bent normal is a quotient).
// Delete-one jackknife over the replicates [Efron81]: with T the function of the means over all replicates, T_j that
// over all but the j-th, and M replicates,
//   estimate = T,   stderr^2 = (M - 1) / M * sum_j (T_j - mean T_j)^2,
// which for the identity is the usual s / sqrt(M). With M = 16 the quotient (estimate - truth) / stderr follows
// Student's t with 15 degrees of freedom where the replicates are normal: within +-2 in 93.6 % of cases.
// Where all samples are equal the error is 0: rays say nothing about what none of them has met.
#pragma once

#include <array>
#include <cmath>

namespace isolume {

inline constexpr int kReplicates = 16;
inline constexpr int kMaxChannels = 4;
using Channels = std::array<double, kMaxChannels>;

inline void add(Channels& sum, const Channels& term) {
  for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += term[c];
}

struct ChannelEstimate {
  Channels value{}, standardError{};
};

/// `sums`: of `count` samples in each replicate. `shown` maps means to what is estimated, Channels to Channels.
template <class Shown>
ChannelEstimate estimateOf(const std::array<Channels, kReplicates>& sums, int count, Shown shown) {
  Channels total{};
  for (const Channels& sum : sums) add(total, sum);
  const auto shownMean = [&](const Channels& sum, double samples) {
    Channels mean{};
    for (std::size_t c = 0; c < mean.size(); ++c) mean[c] = sum[c] / samples;
    return shown(mean);
  };
  ChannelEstimate estimate{shownMean(total, static_cast<double>(count) * kReplicates), {}};
  std::array<Channels, kReplicates> without;
  Channels meanWithout{};
  for (int j = 0; j < kReplicates; ++j) {
    Channels rest = total;
    for (std::size_t c = 0; c < rest.size(); ++c) rest[c] -= sums[j][c];
    without[j] = shownMean(rest, static_cast<double>(count) * (kReplicates - 1));
    add(meanWithout, without[j]);
  }
  for (std::size_t c = 0; c < meanWithout.size(); ++c) {
    double squares = 0;
    for (const Channels& each : without) {
      const double deviation = each[c] - meanWithout[c] / kReplicates;
      squares += deviation * deviation;
    }
    estimate.standardError[c] = std::sqrt(squares * (kReplicates - 1) / kReplicates);
  }
  return estimate;
}

}  // namespace isolume
