// Directions of the ordinates: a spherical Fibonacci lattice ([Swinbank06]), one direction per equal area.
//
// Direction i of K has height 1 - (2 i + 1) / K about the lattice's axis and is turned by i golden angles, so that any
// cap holds its share of directions to within a few. The axis is turned away from the grid's: a set that shares the
// grid's symmetry sees aligned walls edge on with many ordinates at once (study: twice the error of this one).
#pragma once

#include <glm/vec3.hpp>
#include <vector>

namespace isolume {

/// `count` unit vectors in world space, count >= 1. With equal weights their clamped cosines add up to count / 4 for
/// any normal, to about 0.6 / count^(1/4) (measured).
std::vector<glm::dvec3> ordinateDirections(int count);

}  // namespace isolume
