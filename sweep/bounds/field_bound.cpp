#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "lower_bound.h"
#include "sweep/half.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

constexpr int kCorners = 8;
// Differences, squares, sums and the root in double, then one rounding to float: far below this. So is the rounding of
// FieldBound::operator() below it, three times 2^-24.
constexpr double kRoundedUp = 1 + 0x1p-21;

float magnitudeOf(float value) { return std::abs(value); }
float magnitudeOf(std::uint16_t half) { return std::abs(floatFromHalf(half)); }

struct Largest {
  double shift = 0, slopeSquared = 0;
  bool finite = true;
};

// |grad|^2 at the corner of a cell: the three edges that meet there.
double steepestCorner(const double (&value)[kCorners], glm::dvec3 inverse) {
  double steepest = 0;
  for (int corner = 0; corner < kCorners; ++corner) {
    double sum = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double slope = (value[corner] - value[corner ^ (1 << axis)]) * inverse[axis];
      sum += slope * slope;
    }
    steepest = std::max(steepest, sum);
  }
  return steepest;
}

template <class T>
Largest largestOfPlane(GridView<const float> level, GridView<const T> field, glm::dvec3 inverse, int z) {
  Largest largest;
  for (int y = 0; y + 1 < level.size.y; ++y) {
    for (int x = 0; x + 1 < level.size.x; ++x) {
      int inside = 0;
      double value[kCorners], highest = 0;
      for (int corner = 0; corner < kCorners; ++corner) {
        const std::size_t at = level.index(x + (corner & 1), y + ((corner >> 1) & 1), z + (corner >> 2));
        inside += level.data[at] > 0;
        value[corner] = magnitudeOf(field.data[at]);
        largest.finite = largest.finite && std::isfinite(value[corner]);
        highest = std::max(highest, value[corner]);
      }
      if (inside != 0 && inside != kCorners)
        largest.shift = std::max(largest.shift, highest);
      else
        largest.slopeSquared = std::max(largest.slopeSquared, steepestCorner(value, inverse));
    }
  }
  return largest;
}

template <class T>
FieldBound certify(GridView<const float> level, GridView<const T> field) {
  const double smallest = smallestSpacing(level.spacing);
  const glm::dvec3 inverse = smallest / level.spacing;
  std::vector<Largest> planes(static_cast<std::size_t>(level.size.z - 1));
  parallelFor(planes.size(),
              [&](std::size_t z) { planes[z] = largestOfPlane(level, field, inverse, static_cast<int>(z)); });
  Largest largest;
  for (const Largest& plane : planes) {
    largest.shift = std::max(largest.shift, plane.shift);
    largest.slopeSquared = std::max(largest.slopeSquared, plane.slopeSquared);
    largest.finite = largest.finite && plane.finite;
  }
  FieldBound bound;
  if (!largest.finite) {
    bound.shift = std::numeric_limits<float>::infinity();
    return bound;
  }
  bound.shift = static_cast<float>(largest.shift * kRoundedUp);
  bound.slope = static_cast<float>(std::max(1.0, std::sqrt(largest.slopeSquared)) * kRoundedUp);
  return bound;
}

}  // namespace

FieldBound certifyField(GridView<const float> level, GridView<const float> field) { return certify(level, field); }

FieldBound certifyField(GridView<const float> level, GridView<const std::uint16_t> field) {
  return certify(level, field);
}

}  // namespace isolume
