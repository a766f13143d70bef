#include "sweep/ordinates/surface_rays.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "ordinates/swept_openness.h"
#include "ordinates/swept_scene.h"
#include "support/test_levels.h"
#include "sweep/ordinates/sky_ordinates.h"

namespace isolume {
namespace {

constexpr glm::ivec3 kSize(30, 27, 33);
constexpr glm::dvec3 kSpacing(1, 0.7, 1.6);

TEST(SurfaceRays, OrdersThatAreRemadeChangeNoBit) {
  // Sums of one and three channels, and those of a second sweep, are the same whether orders are kept or remade, and so
  // is what the surface that is taken out spreads.
  for (const int refinement : {1, 2}) {
    const test::SweptScene scene(test::noiseLevel(kSize, kSpacing, 5), refinement);
    SurfaceRays remade(scene.level.view(), scene.distance.view(), refinement, SurfaceRays::Orders::remade);
    ASSERT_GT(remade.count(), 1000U);
    const glm::dmat3 axes(1);
    for (int sweep = 0; sweep < 2; ++sweep)
      for (const int channels : {1, 3}) {
        const std::vector<Ordinate> sky = bandedSky(100, axes);
        const std::vector<float> want = scene.rays.sum(sky, channels, SurfaceRays::Count::visible);
        EXPECT_GT(*std::max_element(want.begin(), want.end()), 0);
        EXPECT_EQ(remade.sum(sky, channels, SurfaceRays::Count::visible), want) << sweep << ", " << channels;
      }
    std::vector<std::uint16_t> values(remade.count());
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<std::uint16_t>(i);
    const SurfaceField want = scene.rays.surface().spread(values);
    const SurfaceField got = std::move(remade).takeSurface().spread(values);
    EXPECT_EQ(test::paddedNumbers(got), test::paddedNumbers(want));
  }
}

}  // namespace
}  // namespace isolume
