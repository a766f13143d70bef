// Samples of one z plane whose closest points are sought together: structure of arrays for the vector kernels.
//
// Arrays are padded to whole groups of kBatchGroup by copies of the last sample, so that kernels need no tail. Offsets
// are from the sample, in units of the smallest spacing. O(samples) memory: 30 bytes each; buffers are kept by reuse.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace isolume {

/// Not less than the lanes of any vector the kernels use.
inline constexpr std::size_t kBatchGroup = 16;

struct PointBatch {
  std::vector<std::int32_t> x, y;
  std::vector<float> offset[3];       ///< a point of the surface
  std::vector<float> trial[3];        ///< where the search begins: on the surface or near it
  std::vector<std::uint8_t> settled;  ///< result: 1 if `offset` is a closest point, 0 if the search has failed
  std::size_t count = 0;

  /// Room for so many samples, whole groups.
  void resize(std::size_t samples) {
    count = samples;
    const std::size_t padded = (samples + kBatchGroup - 1) / kBatchGroup * kBatchGroup;
    x.resize(padded);
    y.resize(padded);
    settled.resize(padded);
    for (int axis = 0; axis < 3; ++axis) {
      offset[axis].resize(padded);
      trial[axis].resize(padded);
    }
  }
  /// To be called when all samples are in.
  void pad() {
    for (std::size_t i = count; i < x.size(); ++i) {
      x[i] = x[count - 1];
      y[i] = y[count - 1];
      for (int axis = 0; axis < 3; ++axis) {
        offset[axis][i] = offset[axis][count - 1];
        trial[axis][i] = trial[axis][count - 1];
      }
    }
  }
  void set(std::size_t i, glm::vec3 from, glm::vec3 start) {
    for (int axis = 0; axis < 3; ++axis) {
      offset[axis][i] = from[axis];
      trial[axis][i] = start[axis];
    }
  }
  glm::vec3 point(std::size_t i) const { return {offset[0][i], offset[1][i], offset[2][i]}; }
};

}  // namespace isolume
