// Points that repel each other, and what each of them stands for: the sets of [Loos10] Sec. 4.5.
//
// A set is relaxed from several scattered ones: points repel each other by 1 / d^4 and are pulled to the centroids of
// their Voronoi regions, which stands for the paper's charge of the border; a step is taken if the regions become more
// equal, and tried smaller otherwise. The set with the most equal regions wins, and its points are moved one by one as
// long as that evens the regions out. A region is measured by the volume of the ball above it: in the ball its own, on
// the disk that of the chords along the axis, 2 sqrt(1 - x^2 - y^2).
// Regions are counted in cubes of side 2 / 24 (disk: squares of 2 / 96) while points move, and of 2 / 64 (2 / 256) for
// the weights; the paper counts 2 / 128 (2 / 512) throughout. The first call for a count takes from .03 s (5 points)
// over .1 s (12) and .5 s (33) to seconds (256); sets are kept until the program ends. Thread-safe.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

namespace isolume {

struct WeighedPoint {
  glm::dvec3 point;   ///< in the unit ball; of a disk, z = 0
  double weight = 0;  ///< its region's share of the ball; they sum to 1
};

const std::vector<WeighedPoint>& repulsionBall(int count);
/// With the centre as one of the points where the paper found that better, 5, 7, 9, 13 and 16, and as the only one.
const std::vector<WeighedPoint>& repulsionDisk(int count);

/// Root of the mean square of (weight * count - 1): how far from equal the regions are.
double weightSpread(const std::vector<WeighedPoint>& points);

}  // namespace isolume
