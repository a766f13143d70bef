#include "light_row.h"

#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sweep/transport/light_row.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace isolume::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using FloatTag = hn::CappedTag<float, kOrdinateGroup>;

template <bool kDiagonals>
void sweepLanes(const LightRow& row, int lane) {
  const FloatTag d;
  const auto weight = [&](int entry)
                          HWY_ATTR { return hn::LoadU(d, row.weights[static_cast<std::size_t>(entry)].data() + lane); };
  // Entry k: x if bit 0 of k + 1, y if bit 1, z if bit 2.
  const auto wx = weight(0), wy = weight(1), wxy = weight(2), wz = weight(3), wxz = weight(4), wyz = weight(5),
             wxyz = weight(6);
  for (int x = 0; x < row.count; ++x) {
    const std::ptrdiff_t before = static_cast<std::ptrdiff_t>(x) * kOrdinateGroup + lane;
    const std::ptrdiff_t here = before + kOrdinateGroup;
    const auto from = [&](std::size_t which, std::ptrdiff_t at)
                          HWY_ATTR { return hn::LoadU(d, row.upwind[which] + at); };
    auto light = hn::Add(hn::Mul(wy, from(1, here)), hn::Mul(wz, from(2, here)));
    if constexpr (kDiagonals) {
      light = hn::Add(light, hn::Mul(wxy, from(1, before)));
      light = hn::Add(light, hn::Mul(wxz, from(2, before)));
      light = hn::Add(light, hn::Mul(wyz, from(3, here)));
      light = hn::Add(light, hn::Mul(wxyz, from(3, before)));
    }
    light = hn::Add(light, hn::Mul(wx, from(0, before)));
    hn::StoreU(light, d, row.visibility + before);
    const float ramp = row.ramp[x];
    auto tau = hn::Set(d, ramp);
    if (row.powers && ramp > 0 && ramp < 1) {
      OrdinateLanes powers;
      for (std::size_t k = 0; k < hn::Lanes(d); ++k)
        powers[k] = std::pow(ramp, row.power[static_cast<std::size_t>(lane) + k]);
      tau = hn::LoadU(d, powers.data());
    }
    hn::StoreU(hn::Mul(light, tau), d, row.leaving + before);
  }
}

void sweepLightRowOnTarget(const LightRow& row) {
  for (int lane = 0; lane < kOrdinateGroup; lane += static_cast<int>(hn::Lanes(FloatTag())))
    row.diagonals ? sweepLanes<true>(row, lane) : sweepLanes<false>(row, lane);
}

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isolume {

HWY_EXPORT(sweepLightRowOnTarget);

void sweepLightRow(const LightRow& row) { HWY_DYNAMIC_DISPATCH(sweepLightRowOnTarget)(row); }

}  // namespace isolume
#endif
