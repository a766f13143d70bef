// Judges every ray of a picture (ray_judge.h), and measures its hits and normals.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "raymarch/renderer.h"
#include "sweep/reference/reference.h"
#include "tests/bench/rays/ray_judge.h"

namespace isolume::bench {

struct RayCounts {
  std::int64_t rays = 0, hits = 0, caps = 0;  ///< hits: of the renderer, on the isosurface
  std::int64_t ties = 0, grazing = 0, missed = 0, falseHits = 0;
  std::int64_t tangent = 0;            ///< hits whose own line has no root near by (HitQuality)
  std::int64_t flat = 0;               ///< hits without a gradient: no normal to compare with
  std::vector<float> distance;         ///< of each hit on the isosurface: HitQuality::distance, voxels
  std::vector<float> across;           ///< HitQuality::across
  std::vector<float> normal;           ///< degrees between its normal and the same difference quotient in double
  std::vector<float> cellNormal;       ///< degrees between its normal and the gradient of the interpolant in its cell
  std::vector<std::string> offHit;     ///< the first hits more than kSamePlace off along their line, in words
  std::vector<std::string> wrong;      ///< the first misses and false hits in words
  std::vector<std::string> offNormal;  ///< the first normals more than kNormalTarget off, in words

  /// Appends; keeps the order.
  void add(const RayCounts& other);
};

/// Degrees.
inline constexpr double kNormalTarget = 0.1;

/// `frame` has layers and was made with worldFromGrid = the judge's scale: the world is the grid's, in voxels.
/// Threaded; the same for any number of threads.
RayCounts judgePicture(const RayJudge& judge, const Frame& frame, const PixelRays& rays);

/// The ray of a pixel's centre, of unit length in voxels.
GridRay pixelRay(const PixelRays& rays, glm::ivec2 pixel, glm::dvec3 scale);

/// Value below which that share of the numbers lies; 0 for none. Reorders them.
double quantile(std::vector<float>& values, double share);

}  // namespace isolume::bench
