#include "byte_hash.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <string>
#include <vector>

#include "sweep/parallel.h"

namespace isolume {
namespace {

constexpr std::uint64_t kChunk = 1 << 20;
/// The odd number nearest to 2^64 divided by the golden ratio: multiplying by it spreads low bits over the word.
constexpr std::uint64_t kSpread = 0x9e3779b97f4a7c15;

std::uint64_t hashWord(std::uint64_t hash, std::uint64_t word) {
  constexpr int kTurn = 29;  // brings the well mixed high bits down; odd, so that words do not fall on each other
  return std::rotl((hash ^ word) * kSpread, kTurn);
}

std::uint64_t hashChunk(const char* bytes, std::size_t count) {
  std::uint64_t hash = count;
  for (std::size_t i = 0; i < count; i += sizeof(std::uint64_t)) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes + i, std::min(sizeof(word), count - i));
    hash = hashWord(hash, word);
  }
  return hash;
}

}  // namespace

std::uint64_t hashBytes(std::uint64_t size,
                        const std::function<void(std::uint64_t first, std::size_t count, char* to)>& fetch) {
  std::vector<std::uint64_t> parts((size + kChunk - 1) / kChunk);
  parallelFor(parts.size(), [&](std::size_t chunk) {
    const std::uint64_t first = chunk * kChunk;
    std::vector<char> bytes(static_cast<std::size_t>(std::min(kChunk, size - first)));
    fetch(first, bytes.size(), bytes.data());
    parts[chunk] = hashChunk(bytes.data(), bytes.size());
  });
  std::uint64_t hash = size;
  for (const std::uint64_t part : parts) hash = hashWord(hash, part);
  return hash;
}

std::uint64_t hashBytes(std::string_view bytes) {
  return hashBytes(bytes.size(), [&](std::uint64_t first, std::size_t count, char* to) {
    std::memcpy(to, bytes.data() + first, count);
  });
}

}  // namespace isolume
