// Sums over points that groups of directions add to, one array per group at work. Integers: the order of additions does
// not matter.
#pragma once

#include <algorithm>
#include <cstdint>
#include <mutex>
#include <utility>
#include <vector>

#include "sweep/parallel.h"

namespace isolume {

inline constexpr std::size_t kFootChunk = 1 << 15;

/// visit(i) for i in [0, count), threaded.
template <class Visit>
void forEachFoot(std::size_t count, const Visit& visit) {
  parallelFor((count + kFootChunk - 1) / kFootChunk, [&](std::size_t chunk) {
    for (std::size_t i = chunk * kFootChunk; i < std::min((chunk + 1) * kFootChunk, count); ++i) visit(i);
  });
}

class FootSums {
 public:
  explicit FootSums(std::size_t count) : count_(count) {}

  std::vector<std::int32_t> take() {
    const std::lock_guard lock(mutex_);
    if (idle_.empty()) return std::vector<std::int32_t>(count_, 0);
    std::vector<std::int32_t> sums = std::move(idle_.back());
    idle_.pop_back();
    return sums;
  }
  void giveBack(std::vector<std::int32_t> sums) {
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(sums));
  }
  /// Of entry i over all arrays, which start anew.
  std::int32_t takeTotal(std::size_t i) {
    std::int32_t total = 0;
    for (std::vector<std::int32_t>& sums : idle_) {
      total += sums[i];
      sums[i] = 0;
    }
    return total;
  }

 private:
  std::size_t count_;
  std::mutex mutex_;
  std::vector<std::vector<std::int32_t>> idle_;
};

}  // namespace isolume
