// Light that the surface sends to itself: the diffuse part of the rendering equation ([Kajiya86]) by source iteration.
//
// With e = E / pi at a foot, what a point of albedo a sends is the radiance a e in every direction, and
//   e = direct + (1 - A) a m,  m = mean of e over what its blocked directions meet, weighed by max(N . w, 0),
// with A the openness. Each iteration carries the e of the solid samples next to the surface along parallel rays
// (carried_rays.h) and is one more reflection. Since m is a mean, an albedo of 1 under a white sky gives e = 1 at once
// and exactly, in closed cavities too, if it starts from 1. A ray that is read past the surface (sheared_rays.h: up to
// three layers on) may begin inside the solid, where nothing has a value: the mean is over the others, and a foot
// without any takes its own e.
//
// Iterations run as many as asked for, or until the change that is left is small: then they start from what m = `start`
// gives, which should be at least the solution, and the geometric series of the last changes is added ([Aitken26]).
// Feet that meet nothing have their solution at once: else their first change would hide the series of the others.
// Memory: 9 bytes per sample next to the surface for each axis, 28 per foot, and while it runs carried_rays.h.
#pragma once

#include <vector>

#include "sample_layers.h"
#include "surface_rays.h"

namespace isolume {

struct ReflectionOptions {
  int ordinates = 72;
  int bounces = 0;          ///< reflections; 0: all
  float tolerance = 2e-3F;  ///< of all: RMS of the change that is left, in units of the largest e
  int mostBounces = 64;     ///< of all
};

struct ReflectedLight {
  std::vector<float> light;  ///< e of each foot without the direct one
  int bounces = 0;           ///< iterations
};

class InterReflection {
 public:
  /// `rays` of refinement 1, borrowed. What does not depend on the light: rays and samples in order.
  InterReflection(const SurfaceRays& rays, int ordinates);

  /// `direct` and `blocked` (blockedShares(), of any ordinates) by foot, albedo in [0, 1].
  ReflectedLight reflect(const std::vector<float>& direct, const std::vector<float>& blocked, float albedo, float start,
                         const ReflectionOptions& options) const;

 private:
  std::vector<float> meanMet(const std::vector<float>& light, int iteration) const;
  std::vector<float> carriedSums(const std::vector<std::uint8_t>& values) const;

  const SurfaceRays& rays_;
  std::vector<Ordinate> ordinates_;
  std::vector<NearSample> samples_;
  std::array<SampleLayers, 3> layers_;
  std::vector<float> met_;  ///< sum of clamped cosines over what is met and has a value
};

}  // namespace isolume
