#include "large_array.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <new>

#include "parallel.h"

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace isolume {
namespace {

constexpr std::size_t kLineBytes = 64;                   // a cache line, and the widest vector
constexpr std::size_t kHugePageBytes = 2 * 1024 * 1024;  // x86-64

}  // namespace

void* allocateLargeArray(std::size_t bytes) {
  const std::size_t alignment = bytes >= 2 * kHugePageBytes ? kHugePageBytes : kLineBytes;
  const std::size_t rounded = (bytes + alignment - 1) / alignment * alignment;
  if (rounded < bytes) throw std::bad_alloc();
  void* memory = std::aligned_alloc(alignment, rounded == 0 ? alignment : rounded);
  if (memory == nullptr) throw std::bad_alloc();
#ifdef __linux__
  if (alignment == kHugePageBytes) madvise(memory, rounded, MADV_HUGEPAGE);  // a hint: failure changes nothing
#endif
  return memory;
}

void freeLargeArray(void* memory) { std::free(memory); }

void clearLargeArray(void* memory, std::size_t bytes) {
  auto* const first = static_cast<char*>(memory);
  const auto clear = [&](std::size_t begin, std::size_t end) { std::memset(first + begin, 0, end - begin); };
  if (bytes < 2 * kHugePageBytes) {
    clear(0, bytes);
    return;
  }
  parallelFor((bytes + kHugePageBytes - 1) / kHugePageBytes, [&](std::size_t page) {
    clear(page * kHugePageBytes, std::min((page + 1) * kHugePageBytes, bytes));
  });
}

}  // namespace isolume
