// What eight octants give on an open plane, where the truth is 1: A0(N) = sum_s V_s G_s(N) / pi with the V that Eq. 6
// and 7 of [Singh10] leave above an infinite plane with normal N. Dividing by it takes off what a flat surface shades
// itself.
//
// Above a plane V depends on the height u alone (smallest spacings), and Eq. 6 becomes
//   V(u) = sum_i w_i tau(u + m_i) V(u + m_i),  m_i = sigma_i N_i h_i,  V = 1 far up,
// sigma the signs of the octant's directions; 0 for octants whose drift sum w_i m_i leads down. It is solved on a row
// of heights, and read as pictures read it, by trilinear weights on average over where the point lies between samples.
// A0 depends on the magnitudes of N's components alone, so that a table over a quarter of the hemisphere's equal-area
// square (geometry_terms.h) holds it.
//
// Two voxels above a plane A / A0 is 1 within .01 at any tilt, at the hit within .05: what is left are the stripes in
// which a plane cuts the voxels. Above 1, where light from the border of the grid comes in low, pictures clip it.
//
// Cost: kOpenPlaneSize^2 normals, threaded; the same bits for any number of threads.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "geometry_terms.h"

namespace isolume {

/// V of the octant with directions of signs `sigma`, `offset` voxels above a plane along its unit normal N in index
/// space.
double openPlaneVisibility(glm::dvec3 sigma, glm::dvec3 normal, glm::dvec3 spacing, double offset);

/// A0 of the eight octants, (0, 1].
double openPlaneOpenness(glm::dvec3 normal, glm::dvec3 spacing, double offset);

inline constexpr int kOpenPlaneSize = 17;
struct OpenPlaneTable {
  std::vector<float> openness;  ///< [row][column], (|N.x|, |N.y|) = (column, row) / (size - 1) * sqrt(1 + |N.z|)
  /// Bilinear: within .01.
  double at(glm::dvec3 normal) const;
};
OpenPlaneTable makeOpenPlaneTable(glm::dvec3 spacing, double offset);

/// G_s / A0: with these an open plane gives 1, and A what is left of that.
void divideByOpenPlane(GeometryTermTables& terms, const OpenPlaneTable& plane);

}  // namespace isolume
