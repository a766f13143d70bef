// Evenly spread points of the unit disk and the unit ball, the same on every machine.
//
// Poisson disk: points drawn uniformly, each kept if it is no nearer to another than a distance that shrinks until all
// find a place. Afterwards the points keep their order of radii, but take radii that cut the disk (the ball) into rings
// of equal area (shells of equal volume): dart throwing alone crowds the rim, and turning a set about its axis, which
// is all that interleaving does, would not mend that. One point lies at radius sqrt(1/2) (cbrt(1/2)). O(count^2) per
// try. Thread-safe.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace isolume {

std::vector<glm::dvec2> poissonDisk(int count, std::uint64_t seed = 0);
std::vector<glm::dvec3> poissonBall(int count, std::uint64_t seed = 0);

/// Independent ones: points of the disk, and numbers in [0, 1).
std::vector<glm::dvec2> randomDisk(int count, std::uint64_t seed = 0);
std::vector<double> randomNumbers(int count, std::uint64_t seed = 0);

/// Poisson-disk points without the change of radii: where another order is to come.
std::vector<glm::dvec3> scatteredPoints(int count, bool flat, std::uint64_t seed);

/// (i + 1/2) / count in an order that does not follow i: a further coordinate for the points of a set.
std::vector<double> shuffledStrata(int count, std::uint64_t seed = 0);

}  // namespace isolume
