#include "place_reader.h"

#include "sweep/octants/fixed_light.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sweep/transport/place_reader.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace isolume::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using WideTag = hn::ScalableTag<std::int16_t>;
using NarrowTag = hn::CappedTag<std::int16_t, (HWY_MAX_BYTES > 32 ? HWY_MAX_BYTES / 2 : 16) / sizeof(std::int16_t)>;

template <class D>
HWY_INLINE std::int32_t sumOf(D d, hn::Vec<D> v) {
  const hn::CappedTag<std::int32_t, hn::MaxLanes(D())> d32;
  const hn::Rebind<std::int16_t, decltype(d32)> d16;
  alignas(64) std::int16_t values[hn::MaxLanes(D())];
  hn::Store(v, d, values);
  auto sum = hn::Zero(d32);
  for (std::size_t i = 0; i < hn::Lanes(d); i += hn::Lanes(d32))
    sum = hn::Add(sum, hn::PromoteTo(d32, hn::LoadU(d16, values + i)));
  return hn::GetLane(hn::SumOfLanes(d32, sum));
}

template <class D>
HWY_INLINE PlaceSum readAs(D d, const std::array<const std::int16_t*, 8>& corners, const FixedPlace& place,
                           const std::int16_t* directions) {
  const auto between = [&](hn::Vec<D> from, hn::Vec<D> to, int axis) HWY_ATTR {
    const auto part = hn::Set(d, place.part[static_cast<std::size_t>(axis)]);
    return hn::Add(from, hn::MulFixedPoint15(hn::Sub(to, from), part));
  };
  const auto alongX = [&](std::size_t corner) HWY_ATTR {
    return between(hn::Load(d, corners[corner]), hn::Load(d, corners[corner + 1]), 0);
  };
  const auto light = between(between(alongX(0), alongX(2), 1), between(alongX(4), alongX(6), 1), 2);
  auto cosine = hn::Zero(d);
  for (std::size_t axis = 0; axis < 3; ++axis)
    cosine = hn::SaturatedAdd(
        cosine, hn::MulFixedPoint15(hn::Set(d, place.normal[axis]),
                                    hn::Load(d, directions + static_cast<std::ptrdiff_t>(axis * hn::Lanes(d)))));
  cosine = hn::Max(cosine, hn::Zero(d));
  const auto full = hn::Set(d, kFullLight);
  return {sumOf(d, hn::MulFixedPoint15(cosine, hn::Sub(full, light))), sumOf(d, hn::MulFixedPoint15(cosine, full))};
}

PlaceSum readPlaceOnTarget(const std::array<const std::int16_t*, 8>& corners, const FixedPlace& place,
                           const std::int16_t* directions, int lanes) {
  if (lanes == static_cast<int>(hn::Lanes(WideTag()))) return readAs(WideTag(), corners, place, directions);
  return readAs(NarrowTag(), corners, place, directions);
}

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isolume {

HWY_EXPORT(readPlaceOnTarget);

PlaceSum readPlace(const std::array<const std::int16_t*, 8>& corners, const FixedPlace& place,
                   const std::int16_t* directions, int lanes) {
  return HWY_DYNAMIC_DISPATCH(readPlaceOnTarget)(corners, place, directions, lanes);
}

}  // namespace isolume
#endif
