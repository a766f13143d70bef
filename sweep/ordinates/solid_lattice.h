// Which points of a refined lattice are solid, one bit each, in the two orders that rays along any axis need.
//
// The lattice has `refinement` points per voxel along each axis, the samples among them: size (n - 1) * refinement + 1.
// Point p lies at sample position p / refinement, and is solid where the trilinear interpolant of the level is > 0.
// Memory: refinement^3 / 8 bytes per voxel in each order (refinement 2: 1 B), rows rounded up to words.
#pragma once

#include "bit_rows.h"
#include "sweep/grid.h"

namespace isolume {

struct SolidLattice {
  glm::ivec3 size{0};
  int refinement = 1;
  BitRows alongX;  ///< row y of layer z
  BitRows alongY;  ///< row x of layer z
};

/// `inside`: the samples with level > 0; `refinement` 1 or 2; `outlines`: the distance, exact next to the surface,
/// where convex outlines are to be as wide for digital lines as they are for true ones (outline.h). Threaded.
SolidLattice makeSolidLattice(GridView<const float> level, const BitGrid& inside, int refinement,
                              const GridView<const float>* outlines = nullptr);

}  // namespace isolume
