// Samples of a few planes whose closest points are sought together: structure of arrays for the vector kernels.
//
// Arrays are padded to whole groups of kBatchGroup by copies of the last sample, so that kernels need no tail. Offsets
// are from the sample, in units of the smallest spacing. 68 bytes per sample; meant to be kept and used again: room
// once made stays.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

namespace isolume {

/// Not less than the lanes of any vector the kernels use.
inline constexpr std::size_t kBatchGroup = 16;

/// Planes that the samples of a batch may come from.
inline constexpr int kBatchPlanes = 8;

/// How a search has ended (point_kernels.h).
enum class PointState : std::uint8_t {
  searching,
  settled,  ///< a closest point
  stuck,    ///< on the surface, and no nearer point found although there should be one: a crease or another sheet
  failed    ///< the interpolant has not confirmed any point, or is too flat for float
};

struct PointBatch {
  using Floats = std::vector<float>;
  std::vector<std::int32_t> x, y, z;
  std::array<Floats, 3> offset;   ///< the best point of the surface so far
  std::array<Floats, 3> trial;    ///< the next place to look at: at first, on the surface or near it
  std::array<Floats, 3> retreat;  ///< the step along the tangent plane at the best point
  Floats nearest;                 ///< squared length of the best point
  Floats promised;                ///< what that step promises: half its square
  Floats share;                   ///< of that step that is tried next
  Floats tries;                   ///< looks since the best point moved
  std::vector<PointState> state;
  std::size_t count = 0;
  int firstPlane = 0;  ///< lowest z that a sample may have; the highest is less than kBatchPlanes above it

  std::size_t padded() const { return (count + kBatchGroup - 1) / kBatchGroup * kBatchGroup; }
  void clear(int firstPlane_) {
    count = 0;
    firstPlane = firstPlane_;
  }
  /// For that many samples, and for a whole vector to be written at any of them.
  void makeRoom(std::size_t samples) {
    if (samples + kBatchGroup <= x.size()) return;
    const std::size_t size = samples + samples / 2 + kBatchGroup;
    for (auto* places : {&x, &y, &z}) places->resize(size);
    for (auto* vectors : {&offset, &trial, &retreat})
      for (Floats& values : *vectors) values.resize(size);
    for (Floats* values : {&nearest, &promised, &share, &tries}) values->resize(size);
    state.resize(size);
  }
  /// Sample i of this batch becomes sample j of `from`.
  void copy(std::size_t i, const PointBatch& from, std::size_t j) {
    x[i] = from.x[j];
    y[i] = from.y[j];
    z[i] = from.z[j];
    for (std::size_t axis = 0; axis < 3; ++axis) {
      offset[axis][i] = from.offset[axis][j];
      trial[axis][i] = from.trial[axis][j];
      retreat[axis][i] = from.retreat[axis][j];
    }
    nearest[i] = from.nearest[j];
    promised[i] = from.promised[j];
    share[i] = from.share[j];
    tries[i] = from.tries[j];
    state[i] = from.state[j];
  }
  /// Fills the groups, once all samples are in.
  void pad() {
    for (std::size_t i = count; i < padded(); ++i) copy(i, *this, count - 1);
  }
  void set(std::size_t i, glm::vec3 point) {
    for (std::size_t axis = 0; axis < 3; ++axis) offset[axis][i] = trial[axis][i] = point[static_cast<int>(axis)];
  }
  glm::ivec3 sample(std::size_t i) const { return {x[i], y[i], z[i]}; }
  glm::vec3 point(std::size_t i) const { return {offset[0][i], offset[1][i], offset[2][i]}; }
};

}  // namespace isolume
