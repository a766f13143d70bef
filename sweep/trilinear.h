// Trilinear interpolation of a dense field.
#pragma once

#include <glm/common.hpp>

#include "grid.h"

namespace isolume {

/// Between two values; equal ones stay what they are, infinite ones too.
inline double mixedValue(double low, double high, double part) { return low == high ? low : low + (high - low) * part; }

/// At a point of index space within a grid of `size` whose samples valueAt(x, y, z) gives; at least one along each
/// axis.
template <class ValueAt>
double trilinear(glm::ivec3 size, const ValueAt& valueAt, glm::dvec3 position) {
  const glm::ivec3 last = size - 1;
  const glm::ivec3 low = glm::clamp(glm::ivec3(position), glm::ivec3(0), last);
  const glm::ivec3 high = glm::min(low + 1, last);
  const glm::dvec3 part = position - glm::dvec3(low);
  const auto row = [&](int y, int z) { return mixedValue(valueAt(low.x, y, z), valueAt(high.x, y, z), part.x); };
  return mixedValue(mixedValue(row(low.y, low.z), row(high.y, low.z), part.y),
                    mixedValue(row(low.y, high.z), row(high.y, high.z), part.y), part.z);
}

template <class T>
double trilinear(GridView<const T> field, glm::dvec3 position) {
  return trilinear(field.size, field, position);
}

}  // namespace isolume
