// Where a point of the surface reads a ray of one direction, one point at a time: what plain_rays.cpp and
// plain_carried.cpp share.
#pragma once

#include <algorithm>
#include <cmath>

#include "sweep/ordinates/ray_points.h"
#include "sweep/ordinates/ray_step.h"
#include "sweep/ordinates/sheared_rays.h"
#include "sweep/ordinates/solid_lattice.h"

namespace isolume::test {

struct PlainLattice {
  const SolidLattice& lattice;
  RayAxes axes;
  glm::vec3 cell;  ///< distance between points, world units

  PlainLattice(const SolidLattice& lattice_, glm::dvec3 spacing, int axis)
      : lattice(lattice_),
        axes(kRayAxes[static_cast<std::size_t>(axis)]),
        cell(spacing / static_cast<double>(lattice_.refinement)) {}

  int length(int axis) const { return lattice.size[axis]; }
  glm::ivec3 point(int bit, int row, int layer) const {
    glm::ivec3 p(0);
    p[axes.bit] = bit;
    p[axes.row] = row;
    p[axes.layer] = layer;
    return p;
  }
  bool holds(int bit, int row, int layer) const {
    return bit >= 0 && row >= 0 && layer >= 0 && bit < length(axes.bit) && row < length(axes.row) &&
           layer < length(axes.layer);
  }
  bool isSolid(int bit, int row, int layer) const {
    const glm::ivec3 p = point(bit, row, layer);
    return (lattice.alongX.row(p.y, p.z)[p.x / 64] >> (p.x % 64) & 1) != 0;
  }
};

/// Where the ray through (0, 0) of layer 0 has come to in that layer.
inline int plainOffset(double slope, int layer) { return static_cast<int>(std::floor(slope * layer + 0.5)); }

/// A point of a set and what does not depend on the direction.
struct PlainPoint {
  glm::vec3 at, normal;            ///< bit, row, layer
  int layer = 0;                   ///< the next one towards the light
  float ahead = 0;                 ///< how far that is, signed
  float toClear = 0;               ///< height over the plane from which what is met counts
  float liftBit = 0, liftRow = 0;  ///< lattice points within the layer per height gained

  PlainPoint(const PlainLattice& plain, const RayPoints& points, std::size_t i, int towards, float blur = 0)
      : at(points.bit()[i], points.row()[i], points.layer()[i]),
        normal(points.normalBit()[i], points.normalRow()[i], points.normalLayer()[i]) {
    // A point on a layer is past it on the way up, and stands on it on the way down; all points beyond the last layer
    // look at the first place beyond it.
    const int below = std::clamp(static_cast<int>(std::floor(at.z)), -1, plain.length(plain.axes.layer) - 1);
    layer = below + (towards > 0 ? 1 : 0);
    ahead = static_cast<float>(layer) - at.z;
    const float perBit = normal.x * plain.cell[plain.axes.bit], perRow = normal.y * plain.cell[plain.axes.row];
    toClear = (std::abs(perBit) + std::abs(perRow)) * kClearance + blur;
    const float steepest = std::max(perBit * perBit + perRow * perRow, kSmallestSquare);
    liftBit = perBit / steepest;
    liftRow = perRow / steepest;
  }
  float cosine(const RayDirection& w) const {
    const float alongBit = normal.x * w.weightBit, alongRow = normal.y * w.weightRow,
                alongLayer = normal.z * w.weightLayer;
    return (alongBit + alongRow) + alongLayer;
  }
};

/// The first lattice point that counts.
struct PlainEntry {
  int bit = 0, row = 0, layer = 0;
};

/// How a ray gets clear of the steps of its own plane: by layers that it goes by, 3 at most, and by what it is lifted;
/// one that looks into the solid does not.
inline PlainEntry plainEntry(const PlainPoint& point, int towards, const RayDirection& w) {
  const float cosine = point.cosine(w), rise = cosine * w.risePerCosine;
  int skips = 0;
  float height = rise * std::abs(point.ahead), missing = 0;
  if (cosine > 0) {
    for (int j = 0; j < 3; ++j, height += rise) skips += height <= point.toClear ? 1 : 0;
    missing = std::max(point.toClear - height, 0.0F);
  }
  // The lattice point nearest to where the true ray, lifted, crosses the layer, of those that the digital lines cross;
  // from there along the digital line.
  const auto entry = [&](float at, float lift, double slope) {
    const auto lag = static_cast<float>(slope * point.layer - plainOffset(slope, point.layer));
    const float lifted = (at - lag) + missing * lift, along = point.ahead * static_cast<float>(slope);
    const int read = point.layer + towards * skips;
    return static_cast<int>(std::nearbyint(lifted + along)) + plainOffset(slope, read) -
           plainOffset(slope, point.layer);
  };
  return {entry(point.at.x, point.liftBit, w.slopeBit), entry(point.at.y, point.liftRow, w.slopeRow),
          point.layer + towards * skips};
}

/// visit(bit, row, layer) along the digital line from an entry on, until it returns false or the line leaves the
/// lattice.
template <class Visit>
void walkPlainRay(const PlainLattice& plain, PlainEntry at, int towards, const RayDirection& w, const Visit& visit) {
  const int u = at.bit - plainOffset(w.slopeBit, at.layer), v = at.row - plainOffset(w.slopeRow, at.layer);
  for (int k = at.layer;; k += towards) {
    const int bit = u + plainOffset(w.slopeBit, k), row = v + plainOffset(w.slopeRow, k);
    if (!plain.holds(bit, row, k) || !visit(bit, row, k)) return;
  }
}

}  // namespace isolume::test
