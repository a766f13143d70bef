#include "support/plain_rays.h"

#include <algorithm>
#include <cmath>

namespace isolume::test {
namespace {

struct PlainLattice {
  const SolidLattice& lattice;
  RayAxes axes;

  int length(int axis) const { return lattice.size[axis]; }
  bool holds(int bit, int row, int layer) const {
    return bit >= 0 && row >= 0 && layer >= 0 && bit < length(axes.bit) && row < length(axes.row) &&
           layer < length(axes.layer);
  }
  bool isSolid(int bit, int row, int layer) const {
    glm::ivec3 p(0);
    p[axes.bit] = bit;
    p[axes.row] = row;
    p[axes.layer] = layer;
    return (lattice.alongX.row(p.y, p.z)[p.x / 64] >> (p.x % 64) & 1) != 0;
  }
};

// Where the ray through (0, 0) of layer 0 has come to in that layer.
int offset(double slope, int layer) { return static_cast<int>(std::floor(slope * layer + 0.5)); }

// Walks the digital line through a point of `layer` until it meets something or leaves the lattice.
bool meets(const PlainLattice& lattice, int towards, const RayDirection& w, int bit, int row, int layer, int skips) {
  const int u = bit - offset(w.slopeBit, layer), v = row - offset(w.slopeRow, layer);
  for (int k = layer + towards * skips;; k += towards) {
    const int b = u + offset(w.slopeBit, k), r = v + offset(w.slopeRow, k);
    if (!lattice.holds(b, r, k)) return false;
    if (lattice.isSolid(b, r, k)) return true;
  }
}

// How a ray gets clear of the steps of its own plane: by layers that it goes by, 3 at most, and by what it is lifted.
struct Clearing {
  int skips = 0;
  float missing = 0;
};
Clearing clearingOf(float cosine, float risePerCosine, float layersAhead, float toClear) {
  const float rise = cosine * risePerCosine;
  Clearing clearing;
  float height = rise * layersAhead;
  for (int j = 0; j < 3; ++j, height += rise) clearing.skips += height < toClear ? 1 : 0;
  clearing.missing = std::max(toClear - height, 0.0F);
  return clearing;
}

// The lattice point nearest to where the true ray from `at`, lifted, crosses the layer, of those that the digital lines
// cross.
int entry(float at, float lift, float ahead, double slope, int layer) {
  const auto lag = static_cast<float>(slope * layer - offset(slope, layer));
  const float lifted = (at - lag) + lift, along = ahead * static_cast<float>(slope);
  return static_cast<int>(std::nearbyint(lifted + along));
}

}  // namespace

std::vector<std::int32_t> plainRays(const SolidLattice& lattice, glm::dvec3 spacing, int axis, int towards,
                                    const std::vector<RayDirection>& directions, const RayPoints& points, float scale) {
  const PlainLattice plain{lattice, kRayAxes[static_cast<std::size_t>(axis)]};
  std::vector<std::int32_t> sums;
  for (std::size_t i = 0; i < points.count(); ++i) {
    const float at = points.layer()[i];
    // The next layer towards the light; a point on a layer is past it on the way up, and stands on it on the way down.
    int layer = static_cast<int>(std::floor(at)) + (towards > 0 ? 1 : 0);
    if (towards > 0 && layer < 0) layer = 0;
    if (towards < 0 && layer > lattice.size[axis] - 1) layer = lattice.size[axis] - 1;
    const float ahead = static_cast<float>(layer) - at;
    const glm::vec3 cell(spacing / static_cast<double>(lattice.refinement));
    const float widthBit = std::abs(points.normalBit()[i]) * cell[plain.axes.bit],
                widthRow = std::abs(points.normalRow()[i]) * cell[plain.axes.row],
                widthLayer = std::abs(points.normalLayer()[i]) * cell[plain.axes.layer];
    const float toClear = ((widthBit + widthRow) + widthLayer) * (kClearance - kLift);
    float sum = 0;
    for (const RayDirection& w : directions) {
      const float alongBit = points.normalBit()[i] * w.weightBit, alongRow = points.normalRow()[i] * w.weightRow,
                  alongLayer = points.normalLayer()[i] * w.weightLayer;
      const float cosine = (alongBit + alongRow) + alongLayer;
      if (!(cosine > 0)) continue;
      const Clearing clearing = clearingOf(cosine, w.risePerCosine, std::abs(ahead), toClear);
      const auto liftAlong = [&](float normal, int along) { return clearing.missing * normal * (1 / cell[along]); };
      const float left = ahead - liftAlong(points.normalLayer()[i], plain.axes.layer);
      const int bit = entry(points.bit()[i], liftAlong(points.normalBit()[i], plain.axes.bit), left, w.slopeBit, layer);
      const int row = entry(points.row()[i], liftAlong(points.normalRow()[i], plain.axes.row), left, w.slopeRow, layer);
      if (meets(plain, towards, w, bit, row, layer, clearing.skips)) sum += cosine;
    }
    sums.push_back(static_cast<std::int32_t>(std::lrint(sum * scale)));
  }
  return sums;
}

}  // namespace isolume::test
