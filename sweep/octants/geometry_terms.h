// Integrated geometry term of an octant, G_s(N) = integral over octant s of max(N . w, 0) dw ([Singh10] Eq. 5) or of
// |N . w|, and the two RGBA tables of it that the shader reads.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "sweep/octants.h"

namespace isolume {

/// What a direction counts, as a factor of dw.
enum class GeometryTerm {
  front,      ///< max(N . w, 0)
  bothSides,  ///< |N . w|: light from behind too, through a translucent solid ([Singh10] Sec. 4.2)
};

/// G_s(N) for unit N and octant s of kOctants (directions `towardsLight`), closed form: Lambert's formula for the
/// octant clipped at the horizon of N; of both sides G_s(N) + G_s(-N), G_s those of the front. In [0, pi]; the eight
/// sum to pi, so that sum V_s G_s / pi of an open point is 1; of both sides to 2 pi. Exact to rounding (about 1e-15).
double octantGeometryTerm(int octant, glm::dvec3 normal, GeometryTerm term = GeometryTerm::front);

/// G of the octants 0 to 3 (which are those with towardsLight.z < 0) and 4 to 7, for normals with N.z >= 0; for
/// N.z < 0 mirror N in z and swap the two tables. The centre of texel (i, j) of a size x size table belongs to
/// r = 2 (i, j) / (size - 1) - 1 in [-1, 1]^2 and to the normal with (N.x, N.y) = r sqrt(1 + N.z), |r|^2 = 1 - N.z: the
/// equal-area map, smooth at the horizon |r| = 1, where a table over plain (N.x, N.y) ([Singh10] Fig. 2) has an
/// infinite slope. Texels beyond the rim hold N.z < 0. So N reads at texture coordinate
///   (r (size - 1) / size + 1) / 2  with  r = (N.x, N.y) / sqrt(1 + |N.z|).
struct GeometryTermTables {
  int size = 0;
  std::array<std::vector<glm::vec4>, 2> texels;  ///< row-major, size * size each
};
/// Bilinear lookup is then within 1e-4 of the closed form.
inline constexpr int kGeometryTableSize = 256;
/// size >= 2.
GeometryTermTables makeGeometryTermTables(int size = kGeometryTableSize, GeometryTerm term = GeometryTerm::front);

}  // namespace isolume
