// The samples next to the surface that rays from outside may meet, by layers of each axis.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ray_points.h"

namespace isolume {

/// Samples of the layers of one axis: those of layer k are [begin[k], begin[k + 1]).
struct SampleLayers {
  std::vector<std::uint32_t> begin;
  std::vector<std::uint16_t> column, row;  ///< of each sample, kRayAxes
  std::vector<std::uint32_t> sample;       ///< its number
  RowRange rows;                           ///< that any of them lies in
};

/// In the order of the samples within each layer. 8 bytes per sample.
SampleLayers layersOfSamples(const std::vector<NearSample>& samples, glm::ivec3 size, int axis);

}  // namespace isolume
