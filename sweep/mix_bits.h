// The one hash behind every random number: SplitMix64 ([Steele14]), the same on every machine.
#pragma once

#include <cstdint>

namespace isolume {

/// 2^64 over the golden ratio: states that far apart give numbers that look independent.
inline constexpr std::uint64_t kSplitMixIncrement = 0x9e3779b97f4a7c15U;

/// A bijection of 64-bit numbers: every bit of the result depends on every bit of the argument.
inline std::uint64_t mixBits(std::uint64_t x) {
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31);
}

}  // namespace isolume
