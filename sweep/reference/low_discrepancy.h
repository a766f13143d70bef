// Points that fill the unit square evenly, different for every pixel and every replicate: Owen-scrambled Sobol.
//
// The first two Sobol dimensions form a (0, 2)-sequence: of any 2^k points from the start, one lies in each elementary
// rectangle of area 2^-k. Integrands that need more dimensions (a path of several bounces) take further pairs of the
// same two, each with its own scrambling and its own order of the points ("padding", [Burley20] Sec. 3). Scrambling by
// a hash keeps the stratification and makes every single point uniform, so that the mean over the points has the right
// expectation and independent keys give independent estimates. Pure functions of their arguments: thread-safe, and the
// same on every machine.
//
// [Burley20] for hashed Owen scrambling; the hash's constants after [Vegdahl21]; [Steele14] for the key.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>

#include "sweep/mix_bits.h"

namespace isolume {

/// A key that depends on both, and on their order.
inline std::uint64_t mixKey(std::uint64_t key, std::uint64_t more) {
  return mixBits(key + kSplitMixIncrement * (more + 1));
}

inline std::uint32_t reverseBits(std::uint32_t x) {
  x = (x >> 16) | (x << 16);
  x = ((x & 0xff00ff00U) >> 8) | ((x & 0x00ff00ffU) << 8);
  x = ((x & 0xf0f0f0f0U) >> 4) | ((x & 0x0f0f0f0fU) << 4);
  x = ((x & 0xccccccccU) >> 2) | ((x & 0x33333333U) << 2);
  return ((x & 0xaaaaaaaaU) >> 1) | ((x & 0x55555555U) << 1);
}

/// A permutation in which each bit depends on the bits below it alone: Owen scrambling of a number written backwards.
inline std::uint32_t scrambleReversed(std::uint32_t x, std::uint32_t seed) {
  x ^= x * 0x3d20adeaU;
  x += seed;
  x *= (seed >> 16) | 1U;
  x ^= x * 0x05526c56U;
  x ^= x * 0x53a22864U;
  return x;
}

/// Second Sobol dimension as a 32-bit fraction; the first is reverseBits(index).
inline std::uint32_t sobolSecond(std::uint32_t index) {
  std::uint32_t result = 0;
  for (std::uint32_t column = 1U << 31; index != 0; index >>= 1, column ^= column >> 1)
    if (index & 1U) result ^= column;
  return result;
}

/// Point `index` of the sequence of that key, in (0, 1)^2; `pair` counts the pairs of dimensions.
inline glm::dvec2 scrambledSobol(std::uint64_t key, std::uint32_t pair, std::uint32_t index) {
  constexpr std::uint64_t kOrder = 0, kFirst = 1;  // what the bits of the two hashes are for
  const std::uint64_t own = mixKey(key, pair);
  const std::uint64_t order = mixKey(own, kOrder), values = mixKey(own, kFirst);
  const std::uint32_t shuffled = reverseBits(scrambleReversed(reverseBits(index), static_cast<std::uint32_t>(order)));
  const std::uint32_t x = reverseBits(scrambleReversed(shuffled, static_cast<std::uint32_t>(values)));
  const std::uint32_t y =
      reverseBits(scrambleReversed(reverseBits(sobolSecond(shuffled)), static_cast<std::uint32_t>(values >> 32)));
  return {(x + 0.5) * 0x1p-32, (y + 0.5) * 0x1p-32};
}

}  // namespace isolume
