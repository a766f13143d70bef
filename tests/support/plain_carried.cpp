#include <cmath>

#include "support/plain_rays.h"
#include "support/plain_reading.h"

namespace isolume::test {
namespace {

// exp(-x) for x >= 0 by the same operations as carried_rays.cpp, which must not be fused: 2^whole times a series in the
// rest.
float plainDecay(float x) {
  constexpr float kLog2E = 1.44269504F, kLeastPower = -120;
  const float power = std::max(x * -kLog2E, kLeastPower), whole = std::floor(power), part = power - whole;
  float sum = 0;
  for (const float term :
       {1.54035304e-4F, 1.33335581e-3F, 9.61812911e-3F, 5.55041087e-2F, 2.40226507e-1F, 6.93147181e-1F, 1.0F})
    sum = sum * part + term;
  return std::ldexp(sum, static_cast<int>(whole));
}

}  // namespace

std::vector<std::int32_t> plainCarried(const SolidLattice& lattice, glm::dvec3 spacing, int axis, int towards,
                                       const std::vector<RayDirection>& directions, const RayPoints& points,
                                       GridView<const std::uint8_t> met, const CarriedTally& tally) {
  const PlainLattice plain(lattice, spacing, axis);
  const bool lengths = tally.kind == CarriedTally::Kind::length;
  const glm::vec3 cell(spacing);
  const float voxel = std::min({cell.x, cell.y, cell.z});
  std::vector<std::int32_t> sums((lengths ? 2 : 1) * points.count(), 0);
  const auto rounded = [](float value, float scale) { return static_cast<std::int32_t>(std::lrint(value * scale)); };
  for (std::size_t i = 0; i < points.count(); ++i) {
    const PlainPoint point(plain, points, i, towards, lengths ? kShareBlur * voxel : 0);
    for (const RayDirection& w : directions) {
      const float cosine = point.cosine(w), slope = std::abs(cosine);
      if (!lengths && !(cosine > 0)) continue;
      int first = kNothingMet, total = 0;
      const PlainEntry entry = plainEntry(point, towards, w);
      walkPlainRay(plain, entry, towards, w, [&](int bit, int row, int layer) {
        const glm::ivec3 p = plain.point(bit, row, layer);
        first = met(p.x, p.y, p.z);
        total += first;
        return lengths || first == kNothingMet;
      });
      if (!lengths) {
        if (first != kNothingMet) sums[i] += rounded(cosine * static_cast<float>(first), tally.scale);
        continue;
      }
      float layers = static_cast<float>(total) * (1.0F / kSolidShare);
      // From the surface to the nearer edge of the next layer, and what the shares of four layers lack.
      if (!(cosine > 0)) {
        const float start = point.ahead * static_cast<float>(towards);
        const float depthPerLayer = slope * (w.risePerCosine * (1 / voxel));
        float own = start - 0.5F;
        for (int j = 0; j < 4; ++j) own += std::max(0.5F - depthPerLayer * (start + static_cast<float>(j)), 0.0F);
        layers = std::max(layers + own, 0.0F);
      }
      const float length = layers * w.risePerCosine, weight = slope * w.value[0];
      sums[i] += rounded(weight * plainDecay(length * (1 / tally.meanFreePath)), tally.scale);
      if (!(cosine > 0)) sums[points.count() + i] += rounded(weight * length, tally.lengthScale);
    }
  }
  return sums;
}

}  // namespace isolume::test
