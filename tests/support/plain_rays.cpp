#include "support/plain_rays.h"

#include <array>
#include <cmath>

#include "support/plain_reading.h"

namespace isolume::test {

std::vector<std::int32_t> plainRays(const SolidLattice& lattice, glm::dvec3 spacing, int axis, int towards,
                                    const std::vector<RayDirection>& directions, const RayPoints& points,
                                    const RayTally& tally) {
  const PlainLattice plain(lattice, spacing, axis);
  const auto channels = static_cast<std::size_t>(tally.channels);
  const bool cosineCounts = tally.channels < 4;
  std::vector<std::int32_t> sums(channels * points.count());
  for (std::size_t i = 0; i < points.count(); ++i) {
    const PlainPoint point(plain, points, i, towards);
    std::array<float, kMostChannels> sum{};
    for (const RayDirection& w : directions) {
      const float cosine = point.cosine(w);
      if (!(cosine > 0)) continue;
      bool met = false;
      walkPlainRay(plain, plainEntry(point, towards, w), towards, w, [&](int bit, int row, int layer) {
        met = plain.isSolid(bit, row, layer);
        return !met;
      });
      if (met == tally.visible) continue;
      for (std::size_t c = 0; c < channels; ++c) sum[c] += (cosineCounts ? cosine : 1) * w.value[c];
    }
    for (std::size_t c = 0; c < channels; ++c)
      sums[c * points.count() + i] = static_cast<std::int32_t>(std::lrint(sum[c] * tally.scale));
  }
  return sums;
}

}  // namespace isolume::test
