#include "ranked_bits.h"

#include <utility>
#include <vector>

#include "sweep/parallel.h"

namespace isolume {

RankedBits::RankedBits(BitGrid bits) : bits_(std::move(bits)), first_(makeLargeArray<std::uint32_t>(words())) {
  const auto layers = static_cast<std::size_t>(size().z), words = layers == 0 ? 0 : this->words() / layers;
  std::vector<std::uint32_t> begin(layers, 0);  // of a layer; until they are added up, how many it has
  const std::uint64_t* word = bits_.row(0, 0);
  parallelFor(layers, [&](std::size_t z) {
    for (std::size_t i = z * words; i < (z + 1) * words; ++i) {
      first_[i] = begin[z];
      if (word[i] != 0) begin[z] += static_cast<std::uint32_t>(std::popcount(word[i]));
    }
  });
  for (std::uint32_t& each : begin) {
    const std::uint32_t own = each;
    each = static_cast<std::uint32_t>(count_);
    count_ += own;
  }
  parallelFor(layers, [&](std::size_t z) {
    for (std::size_t i = z * words; i < (z + 1) * words; ++i) first_[i] += begin[z];
  });
}

}  // namespace isolume
