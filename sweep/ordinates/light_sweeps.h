// Light from far away on the surface, by sums over ordinates (surface_rays.h): a sky of any radiance, a disc, and what
// screen-space methods call bent normals. Each result holds one number per sample next to the surface and on caps
// (surface_field.h), to be interpolated at points of the surface. Bitwise the same for any number of threads and any
// SIMD width.
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "surface_rays.h"

namespace isolume {

struct SweptLight {
  SurfaceField values;
  float full = 1;  ///< what 65535 stands for
  /// What a sample, or a value between samples, stands for.
  float valueOf(float sample) const { return sample / 65535 * full; }
};

/// One number per foot, >= 0, in 16 bits with the largest as full.
SweptLight lightOfFeet(const SurfaceFeet& surface, const float* values);

/// A light's field, and its E / pi by foot.
struct SurfaceLight {
  SweptLight field;
  std::vector<float> light;
};

/// E / pi = sum of value[c] max(N . w, 0) over the ordinates that see the sky, for one channel or three: that is the
/// field. An ordinate that stands for the solid angle A and radiance L has the value L A / pi (sky_ordinates.h).
std::vector<SurfaceLight> sweepSky(const SurfaceRays& rays, const std::vector<Ordinate>& sky, int channels);

/// A disc of light that gives E / pi = 1 where it falls straight (and is small). The field is what of the disc is seen,
/// weighed by max(N . w, 0), in [0, 1]: times the disc's mean clamped cosine it is E / pi.
/// Feet that face no part of the disc take the share that their neighbours have. `direction` along the grid's axes, any
/// length but 0; radius in (0, 90] degrees.
SurfaceLight sweepDisc(const SurfaceRays& rays, glm::dvec3 direction, double radiusDegrees, int ordinates);

/// Directions that fill a cap evenly, a golden spiral about its axis.
std::vector<glm::dvec3> capDirections(glm::dvec3 axis, double radiusDegrees, int count);

/// Components of the mean open direction, without a cosine, N_b = integral of V w dw / integral of V dw over the
/// hemisphere about N ([Klehm11] Eq. 2 and 3): its direction is the bent normal, and its length, 1/2 to 1, the cone:
/// C = (1 - max(0, 2 |N_b| - 1)) pi / 2 (Sec. 3.2). 0: all closed. World axes; 0 and 65535 stand for -1 and 1.
std::array<SurfaceField, 3> sweepBentNormals(const SurfaceRays& rays, int ordinates, glm::dmat3 worldFromAxes);
inline float bentComponent(float value) { return value / 32767.5F - 1; }

struct BentNormal {
  glm::vec3 direction{0};  ///< unit; 0 where all is closed
  float cone = 0;          ///< radians, in [0, pi / 2]
};
/// From the mean open direction.
BentNormal bentNormal(glm::vec3 mean);

}  // namespace isolume
