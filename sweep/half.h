// Between float and IEEE half precision (GL_R16F).
#pragma once

#include <bit>
#include <cstdint>

namespace isolume {

/// To nearest, ties to even. Magnitudes beyond the largest half (65504), infinities and NaN become that largest half,
/// with their sign; magnitudes below the smallest normal half (6.1e-5) are rounded to multiples of 2^-24, as IEEE
/// wants. Branch-free, so that loops vectorise.
inline std::uint16_t halfFromFloat(float value) {
  constexpr std::uint32_t kLargest = 0x477fe000u;         // 65504 as float
  constexpr float kSubnormalMagic = 0.5f;                 // 2^-24 is the last place of floats in [0.5, 1)
  constexpr std::uint32_t kSmallestNormal = 0x38800000u;  // 2^-14
  constexpr std::uint32_t kRebias = (127u - 15u) << 23;
  const auto bits = std::bit_cast<std::uint32_t>(value);
  const std::uint32_t magnitude = bits & 0x7fffffffu;
  const std::uint32_t limited = magnitude < kLargest ? magnitude : kLargest;
  const std::uint32_t tieToEven = 0xfffu + ((limited >> 13) & 1u);
  const std::uint32_t normal = (limited - kRebias + tieToEven) >> 13;
  const std::uint32_t subnormal = std::bit_cast<std::uint32_t>(std::bit_cast<float>(limited) + kSubnormalMagic) -
                                  std::bit_cast<std::uint32_t>(kSubnormalMagic);
  const std::uint32_t half = limited < kSmallestNormal ? subnormal : normal;
  return static_cast<std::uint16_t>(((bits >> 16) & 0x8000u) | half);
}

/// The largest IEEE half that is at most `value` >= 0; below the smallest normal half (6.1e-5) 0.
inline std::uint16_t halfBelow(float value) {
  constexpr std::uint32_t kLargest = 0x477fe000U;         // 65504 as float
  constexpr std::uint32_t kSmallestNormal = 0x38800000U;  // 2^-14
  constexpr std::uint32_t kRebias = (127U - 15U) << 23;
  const auto bits = std::bit_cast<std::uint32_t>(value);
  const std::uint32_t limited = bits < kLargest ? bits : kLargest;
  return static_cast<std::uint16_t>(limited < kSmallestNormal ? 0 : (limited - kRebias) >> 13);
}

/// Exact. `half` finite.
inline float floatFromHalf(std::uint16_t half) {
  constexpr std::uint32_t kMagnitude = 0x7fff;
  // Exponents are moved by multiplication, which normalises subnormals too.
  constexpr float kRebias = 0x1p112F;
  const std::uint32_t bits = half;
  const float magnitude = std::bit_cast<float>((bits & kMagnitude) << 13) * kRebias;
  return (bits & ~kMagnitude) != 0 ? -magnitude : magnitude;
}

}  // namespace isolume
