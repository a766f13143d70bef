#include "inter_reflection.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "carried_sums.h"
#include "foot_sums.h"
#include "ordinate_set.h"
#include "sweep/mix_bits.h"

namespace isolume {
namespace {

/// Sums over feet in chunks, in order: the same for any number of threads.
template <class Value>
double sumOver(std::size_t count, const Value& value) {
  std::vector<double> parts((count + kFootChunk - 1) / kFootChunk, 0.0);
  parallelFor(parts.size(), [&](std::size_t chunk) {
    for (std::size_t i = chunk * kFootChunk; i < std::min((chunk + 1) * kFootChunk, count); ++i)
      parts[chunk] += value(i);
  });
  double sum = 0;
  for (const double part : parts) sum += part;
  return sum;
}

/// Ratio of a geometric series of changes, from two that follow each other.
double ratioOf(const std::vector<float>& change, const std::vector<float>& before) {
  constexpr double kLargestRatio = 0.95;
  const double square = sumOver(before.size(), [&](std::size_t i) { return double{before[i]} * before[i]; });
  const double product = sumOver(before.size(), [&](std::size_t i) { return double{before[i]} * change[i]; });
  return square > 0 ? std::clamp(product / square, 0.0, kLargestRatio) : 0;
}

}  // namespace

InterReflection::InterReflection(const SurfaceRays& rays, int ordinates)
    : rays_(rays), samples_(rays.surface().nearSamples(true)), layers_(orderSamples(samples_, rays.lattice().size)) {
  for (const glm::dvec3& direction : ordinateDirections(ordinates)) ordinates_.push_back({direction});
  met_ = carriedSums(std::vector<std::uint8_t>(samples_.size(), kLargestCarried));
}

std::vector<float> InterReflection::carriedSums(const std::vector<std::uint8_t>& values) const {
  std::vector<float> sums = sumCarried(rays_, ordinates_, layers_, values, CarriedTally::Kind::nearest, 1);
  for (float& each : sums) each /= kLargestCarried;
  return sums;
}

// Values are rounded at random by less than a step, so that what is rounded away in one place
// is not lost everywhere.
std::vector<float> InterReflection::meanMet(const std::vector<float>& light, int iteration) const {
  const float largest = *std::max_element(light.begin(), light.end());
  std::vector<float> mean = light;
  if (!(largest > 0)) return mean;
  std::vector<std::uint8_t> values(samples_.size());
  forEachFoot(samples_.size(), [&](std::size_t i) {
    constexpr double kStep = 1.0 / 4294967296.0;
    const std::uint64_t bits = mixBits(static_cast<std::uint64_t>(iteration) << 32 | i);
    const double dither = static_cast<double>(bits >> 32) * kStep;
    const double share = std::max(light[samples_[i].foot], 0.0F) / largest;
    values[i] = static_cast<std::uint8_t>(std::min(share * kLargestCarried + dither, double{kLargestCarried}));
  });
  const std::vector<float> sums = carriedSums(values);
  forEachFoot(light.size(), [&](std::size_t i) {
    if (met_[i] > 0) mean[i] = std::min(largest * sums[i] / met_[i], largest);
  });
  return mean;
}

ReflectedLight InterReflection::reflect(const std::vector<float>& direct, const std::vector<float>& blocked,
                                        float albedo, float start, const ReflectionOptions& options) const {
  assert(direct.size() == rays_.count() && blocked.size() == rays_.count());
  ReflectedLight result;
  const std::size_t count = direct.size();
  const bool all = options.bounces == 0;
  std::vector<float> light(count), change(count), before;
  // Sums over ordinates may exceed 1 by what the set's cosines do.
  const auto sent = [&](std::size_t i) { return albedo * std::clamp(blocked[i], 0.0F, 1.0F); };
  for (std::size_t i = 0; i < count; ++i) light[i] = direct[i] + (all ? sent(i) * start : 0);
  if (count == 0 || albedo == 0) {
    result.light.assign(count, 0);
    return result;
  }
  const auto add = [&](double factor) {
    forEachFoot(count, [&](std::size_t i) {
      light[i] = std::max(light[i] + static_cast<float>(factor * change[i]), direct[i]);
    });
  };
  const int most = all ? options.mostBounces : options.bounces;
  while (result.bounces < most) {
    const std::vector<float> met = meanMet(light, result.bounces++);
    forEachFoot(count, [&](std::size_t i) {
      const float next = direct[i] + sent(i) * met[i];
      change[i] = next - light[i];
    });
    add(1);
    if (all && !before.empty()) {
      const double ratio = ratioOf(change, before), rest = ratio / (1 - ratio);
      const double rms = std::sqrt(sumOver(count, [&](std::size_t i) { return double{change[i]} * change[i]; }) /
                                   static_cast<double>(count));
      add(rest);
      if (rest * rms <= options.tolerance * *std::max_element(light.begin(), light.end())) break;
      before.clear();
      continue;
    }
    before = change;
  }
  result.light.resize(count);
  for (std::size_t i = 0; i < count; ++i) result.light[i] = light[i] - direct[i];
  return result;
}

}  // namespace isolume
