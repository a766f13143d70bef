// The sky as bent normals and cones look it up ([Klehm11] Sec. 3.3): for a direction w and a half-angle a
//   L_c(w, a) = t / pi * integral of L(w_i) max(w . w_i, 0) dw_i over the directions within a of w,  t = 1 / sin^2 a,
// the mean radiance of the cone, weighed by the cosine; with a = pi / 2 that is the paper's L_p, what a surface with
// the normal w receives in the open.
//
// The paper prints t = 1 / (1 - cos a) and says that a constant sky gives the same for all angles, which holds for
// t = 1 / (1 - cos^2 a): that is taken. The printed one is L_c (1 + cos a); it belongs to the geometric term, where
// shaders/screen/bent_light.glsl has it.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "raymarch/screen/sky_cube.h"

namespace isolume {

/// The angles of the paper's implementation: (k + 1) / kConeAngles of pi / 2.
inline constexpr int kConeAngles = 8;
/// Texels along each edge of a face: 2.8 degrees, a quarter of the narrowest cone.
inline constexpr int kConeSide = 32;

double coneAngle(int k);

/// One cube of kConeSide for each angle from coneAngle(first) on. Sums over the sky at kConeSide; a texel counts as far
/// as it lies within the cone, and t is that of the same sum, so that a constant sky is constant to rounding. 72 KiB
/// for each angle; 38 million pairs of texels, threaded.
std::vector<std::vector<glm::vec3>> convolvedSky(const SkyCube& sky, int first);

}  // namespace isolume
