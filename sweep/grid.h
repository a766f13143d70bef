// Dense 3D grids: GridView borrows, Grid owns.
//
// Index order: x fastest, then y, then z. A value belongs to the sample point (voxel centre) at index (i, j, k), which
// lies at origin + spacing * (i, j, k) in grid-aligned physical space. Where the grid stands in the world (rotation,
// reflection) is the business of whoever holds a worldFromGrid matrix; distances need the spacing alone.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <glm/vec3.hpp>
#include <type_traits>

#include "large_array.h"

namespace isolume {

/// Number of samples of a grid of that size. 64-bit: 2048^3 does not fit into 32.
inline std::size_t voxelCount(glm::ivec3 size) {
  return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * static_cast<std::size_t>(size.z);
}

/// The length that the numerics take as their unit ("voxel").
inline double smallestSpacing(glm::dvec3 spacing) { return std::min({spacing.x, spacing.y, spacing.z}); }

/// Borrowed dense grid. Copying copies the pointer. Thread-safe for reading.
template <class T>
struct GridView {
  T* data = nullptr;
  glm::ivec3 size{0};
  glm::dvec3 spacing{1};  ///< distance between neighbouring samples along each axis, world units, > 0
  glm::dvec3 origin{0};   ///< position of sample (0, 0, 0), grid-aligned, world units

  GridView() = default;
  GridView(T* data_, glm::ivec3 size_, glm::dvec3 spacing_ = glm::dvec3(1), glm::dvec3 origin_ = glm::dvec3(0))
      : data(data_), size(size_), spacing(spacing_), origin(origin_) {}
  /// A view for writing is also a view for reading.
  template <class U>
  requires std::is_same_v<const U, T> GridView(GridView<U> other)
      : GridView(other.data, other.size, other.spacing, other.origin) {}

  std::ptrdiff_t strideY() const { return size.x; }
  std::ptrdiff_t strideZ() const { return static_cast<std::ptrdiff_t>(size.x) * size.y; }
  std::size_t count() const { return voxelCount(size); }
  std::size_t index(int x, int y, int z) const {
    assert(x >= 0 && y >= 0 && z >= 0 && x < size.x && y < size.y && z < size.z);
    return static_cast<std::size_t>(z * strideZ() + y * strideY() + x);
  }
  T& operator()(int x, int y, int z) const { return data[index(x, y, z)]; }
};

/// Owned dense grid: sizeof(T) bytes per voxel. Move-only. The constructor leaves the values uninitialised, so that the
/// first write decides on which core's memory a page lies and nothing is written twice.
template <class T>
class Grid {
 public:
  Grid() = default;
  explicit Grid(glm::ivec3 size, glm::dvec3 spacing = glm::dvec3(1), glm::dvec3 origin = glm::dvec3(0))
      : values_(makeLargeArray<T>(voxelCount(size))), size_(size), spacing_(spacing), origin_(origin) {}

  bool empty() const { return !values_; }
  glm::ivec3 size() const { return size_; }
  std::size_t count() const { return voxelCount(size_); }
  GridView<T> view() { return {values_.get(), size_, spacing_, origin_}; }
  GridView<const T> view() const { return {values_.get(), size_, spacing_, origin_}; }
  T* data() { return values_.get(); }
  const T* data() const { return values_.get(); }

 private:
  LargeArray<T> values_;
  glm::ivec3 size_{0};
  glm::dvec3 spacing_{1};
  glm::dvec3 origin_{0};
};

}  // namespace isolume
