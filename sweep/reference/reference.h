// The Monte Carlo reference: pixels of a picture by exact rays ([Kajiya86] with all light from outside the volume),
// each with an estimate and its standard error. Shares nothing with the sweeps and the shaders but the volume and the
// camera.
//
// Every estimate is the mean over kReplicates independently scrambled low-discrepancy sequences of equal length
// (replicates.h, low_discrepancy.h). Their keys hash (seed, x, y, replicate), so that a pixel has the same bits in any
// rectangle, for any number of threads. Without a target error each pixel takes `rays` samples. With one it goes on
// until the error of each channel is at most that: it starts with 1 / target samples, since what fewer rays than one in
// 1 / target meet cannot move the estimate by more than the target while it can hide from the spread, and doubles them
// until `maxRays`. Stopping by an estimated error favours pixels whose error is estimated too low, by up to a sixth in
// RMS; so it goes on until the estimate is below the target by the estimate's own relative error, kStopMargin.
// Cost: one traced ray per sample (`bounce`: one per reflection more; `translucent`: two). No allocation but the
// result.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "sweep/reference/integrands.h"

namespace isolume {

/// Camera rays in index space: at p, in pixels from the centre of the picture (x right, y down), the ray is
/// origin + originX p.x + originY p.y with the direction built alike. It starts at its origin.
struct PixelRays {
  glm::ivec2 size{0};  ///< of the whole picture, pixels
  glm::dvec3 origin{0}, originX{0}, originY{0};
  glm::dvec3 direction{0, 0, 1}, directionX{0}, directionY{0};
};

/// Pixels begin.x <= x < end.x, begin.y <= y < end.y; row 0 is the top one.
struct PixelRect {
  glm::ivec2 begin{0}, end{0};
};

/// The standard error of kReplicates values is known to 1 / sqrt(2 (kReplicates - 1)) of itself, 18 %.
inline constexpr double kStopMargin = 1.18;

struct SamplingSettings {
  int rays = 256;                          ///< samples per pixel, a multiple of kReplicates
  std::optional<double> targetError = {};  ///< goes on until each channel's standard error is at most this; > 0
  int maxRays = 65536;                     ///< with a target: a multiple of kReplicates
  std::uint64_t seed = 0;
};

/// An estimate at one point and what it took.
struct PointEstimate {
  ChannelEstimate channels;
  int rays = 0;
  bool converged = true;  ///< the target error, if there is one, was reached
};

struct ReferencePixel {
  bool hit = false;
  ShadedPoint point;
  PointEstimate estimate;
};

/// `stream` tells points apart whose samples shall be independent.
PointEstimate estimateAt(const ReferenceScene& scene, const IntegrandSettings& settings,
                         const SamplingSettings& sampling, const ShadedPoint& point, std::uint64_t stream);

/// Row-major over the rectangle; threaded.
std::vector<ReferencePixel> traceReference(const ReferenceScene& scene, const PixelRays& rays, const PixelRect& rect,
                                           const IntegrandSettings& settings, const SamplingSettings& sampling);

}  // namespace isolume
