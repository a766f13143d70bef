#include "src/compare/ssim.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <vector>

#include "sweep/parallel.h"

namespace isolume {
namespace {

constexpr int kRadius = 5;          ///< [Wang04]: 11 x 11
constexpr double kSigma = 1.5;      ///< [Wang04], pixels
constexpr double kMinWeight = .25;  ///< see the header

constexpr int kTaps = 2 * kRadius + 1;
using Window = std::array<double, kTaps>;

Window gaussian() {
  Window window{};
  double sum = 0;
  for (int i = 0; i < kTaps; ++i) {
    const double x = (i - kRadius) / kSigma;
    window[static_cast<std::size_t>(i)] = std::exp(-0.5 * x * x);
    sum += window[static_cast<std::size_t>(i)];
  }
  for (double& weight : window) weight /= sum;
  return window;
}

/// Weighted sums over (part of) a window: of 1, x, y, x^2, y^2 and x y.
struct Moments {
  double w = 0, x = 0, y = 0, xx = 0, yy = 0, xy = 0;

  void add(double weight, const Moments& m) {
    w += weight * m.w;
    x += weight * m.x;
    y += weight * m.y;
    xx += weight * m.xx;
    yy += weight * m.yy;
    xy += weight * m.xy;
  }
};

double similarity(const Moments& m, double range) {
  constexpr double kLuminance = .01, kContrast = .03;  // K1, K2 of [Wang04]
  const double c1 = kLuminance * range * kLuminance * range, c2 = kContrast * range * kContrast * range;
  const double mx = m.x / m.w, my = m.y / m.w;
  const double sxx = m.xx / m.w - mx * mx, syy = m.yy / m.w - my * my, sxy = m.xy / m.w - mx * my;
  return (2 * mx * my + c1) * (2 * sxy + c2) / ((mx * mx + my * my + c1) * (sxx + syy + c2));
}

struct RowSum {
  std::size_t count = 0;
  double sum = 0;
};

}  // namespace

std::optional<double> structuralSimilarity(glm::ivec2 size, std::span<const float> got, std::span<const float> want,
                                           std::span<const std::uint8_t> compared, double range) {
  assert(range > 0 && got.size() == want.size() && got.size() == compared.size());
  const Window window = gaussian();
  const auto width = static_cast<std::size_t>(size.x);
  std::vector<RowSum> rows(static_cast<std::size_t>(size.y));
  parallelFor(rows.size(), [&](std::size_t row) {
    const int y = static_cast<int>(row);
    std::vector<Moments> columns(width);
    for (int v = std::max(0, y - kRadius); v <= std::min(size.y - 1, y + kRadius); ++v) {
      const double weight = window[static_cast<std::size_t>(v - y + kRadius)];
      for (std::size_t x = 0; x < width; ++x) {
        const std::size_t i = static_cast<std::size_t>(v) * width + x;
        if (!compared[i]) continue;
        const double a = got[i], b = want[i];
        columns[x].add(weight, {1, a, b, a * a, b * b, a * b});
      }
    }
    for (int x = 0; x < size.x; ++x) {
      if (!compared[row * width + static_cast<std::size_t>(x)]) continue;
      Moments moments;
      for (int u = std::max(0, x - kRadius); u <= std::min(size.x - 1, x + kRadius); ++u)
        moments.add(window[static_cast<std::size_t>(u - x + kRadius)], columns[static_cast<std::size_t>(u)]);
      if (moments.w < kMinWeight) continue;
      ++rows[row].count;
      rows[row].sum += similarity(moments, range);
    }
  });
  RowSum total;
  for (const RowSum& row : rows) {
    total.count += row.count;
    total.sum += row.sum;
  }
  if (total.count == 0) return std::nullopt;
  return total.sum / static_cast<double>(total.count);
}

}  // namespace isolume
