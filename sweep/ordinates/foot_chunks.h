// Feet in chunks that are made when they are asked for: numbers of 24 bytes each that are cheaper to make again than to
// keep and to read.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace isolume {

struct SurfaceFoot;

struct FootChunks {
  std::vector<std::size_t> begin{0};  ///< number of the first foot of each chunk, and how many feet there are
  /// Adds those of a chunk to `feet`; the same each time. Thread-safe.
  std::function<void(std::size_t chunk, std::vector<SurfaceFoot>& feet)> add;

  std::size_t chunks() const { return begin.size() - 1; }
  std::size_t count() const { return begin.back(); }
};

}  // namespace isolume
