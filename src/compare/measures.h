// Numbers that sum up the differences between two pictures.
//
// With d_i = got_i - want_i over the n pixels that are compared:
//   bias = sum d_i / n,  mean = sum |d_i| / n,  rmse = sqrt(sum d_i^2 / n),  max = max |d_i|,
//   p-th percentile = the ceil(p n / 100)-th smallest |d_i| (nearest rank: always one of the values).
// Sums are taken in double, pixel after pixel within a row, then row after row: bitwise the same for any number of
// threads. O(pixels). Thread-safe.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <optional>
#include <string>
#include <vector>

#include "src/compare/layer_pair.h"

namespace isolume {

/// Differences of a picture; NaN where a pixel is not compared.
struct DifferenceField {
  std::string name;  ///< the channel, or "angle" or "distance"
  std::string unit;  ///< "degrees", "world" or ""
  glm::ivec2 size{0};
  std::vector<double> values;  ///< row-major, top row first
};

/// got - want of one channel.
DifferenceField channelDifference(const LayerPair& pair, const ChannelPair& channel);

/// How far two vectors are apart, never below 0. Directions: the angle in degrees, for vectors of any length; 0 if both
/// are zero, 180 (the worst) if only one is. Positions: the distance in world units.
DifferenceField vectorDifference(const LayerPair& pair);

struct Measures {
  std::size_t count = 0;  ///< pixels compared; everything below is 0 if there are none
  double rmse = 0, bias = 0, mean = 0, p95 = 0, max = 0;
  glm::ivec2 maxPixel{0};  ///< x to the right, y downwards from 0; the first in row-major order with that maximum
};
Measures measure(const DifferenceField& difference);

/// Nearest rank of |difference|, percent in [1, 100]; 0 if nothing is compared.
double magnitudePercentile(const DifferenceField& difference, int percent);

/// sqrt(mean standard error^2) over the pixels that are compared: the RMSE that the noise of WANT alone would give.
/// None if the channel has no standard error or nothing is compared.
std::optional<double> referenceNoise(const LayerPair& pair, const ChannelPair& channel);

}  // namespace isolume
