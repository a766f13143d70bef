// Lanes of a vector by the bits of a word.
// Included once per SIMD target.
#include <cstdint>
#include <cstring>

#if defined(ISOLUME_BIT_MASK_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef ISOLUME_BIT_MASK_INL_H_
#undef ISOLUME_BIT_MASK_INL_H_
#else
#define ISOLUME_BIT_MASK_INL_H_
#endif

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace isolume::HWY_NAMESPACE {

/// Lane i by bit i; bits beyond the lanes do not count.
template <class D>
HWY_INLINE hwy::HWY_NAMESPACE::Mask<D> maskOf(D d, std::uint64_t bits) {
  std::uint8_t bytes[8];  // as many as LoadMaskBits may read
  std::memcpy(bytes, &bits, sizeof bits);
  return hwy::HWY_NAMESPACE::LoadMaskBits(d, bytes);
}

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
