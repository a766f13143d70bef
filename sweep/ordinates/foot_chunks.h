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
  /// Those of a chunk, the same each time: where they are kept, or made in `room`, whose contents are lost.
  /// Thread-safe.
  std::function<const SurfaceFoot*(std::size_t chunk, std::vector<SurfaceFoot>& room)> feet;

  std::size_t chunks() const { return begin.size() - 1; }
  std::size_t count() const { return begin.back(); }

  /// The feet of the first `count` chunks one after the other, begin[count] of them. Threaded.
  void copyFirst(std::size_t count, SurfaceFoot* to) const;
};

}  // namespace isolume
