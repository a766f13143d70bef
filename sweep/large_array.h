// Uninitialised memory for grids: on Linux, large arrays ask for huge pages, which saves most of the page faults of the
// first write (at 256^3 a fifth of the time of the whole sweep).
#pragma once

#include <cstddef>
#include <memory>
#include <type_traits>

namespace isolume {

/// 64-byte aligned; throws std::bad_alloc. Free with freeLargeArray().
void* allocateLargeArray(std::size_t bytes);
void freeLargeArray(void* memory);
/// Threaded where it is large.
void clearLargeArray(void* memory, std::size_t bytes);

struct LargeArrayDelete {
  void operator()(void* memory) const { freeLargeArray(memory); }
};

/// Owned array of values that need no construction.
template <class T>
using LargeArray = std::unique_ptr<T[], LargeArrayDelete>;

template <class T>
LargeArray<T> makeLargeArray(std::size_t count) {
  static_assert(std::is_trivially_copyable_v<T> && std::is_trivially_destructible_v<T>);
  return LargeArray<T>(static_cast<T*>(allocateLargeArray(count * sizeof(T))));
}

template <class T>
LargeArray<T> makeZeroArray(std::size_t count) {
  LargeArray<T> array = makeLargeArray<T>(count);
  clearLargeArray(array.get(), count * sizeof(T));
  return array;
}

}  // namespace isolume
