// The octants as one number: their mean by intensity, without a geometry term.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "support/test_levels.h"
#include "sweep/occlusion_sweep.h"

namespace isolume {
namespace {

using test::noiseLevel;

constexpr OctantIntensities kUneven{0, 0.5F, 3, 1, 0, 2, 0.25F, 7};

// |combined - 65535 sum I V / sum I| at every sample: half a step, half a unit of 2^-15 in each of eight shares and in
// each of eight products, and six for what each V is off by, the roundings of its neighbours.
void expectMeanOf(const std::array<Grid<float>, kOctantCount>& octants, const OctantIntensities& intensities,
                  const Grid<std::uint16_t>& combined) {
  constexpr double kBound = 0.5 + 2 * (4 + 4 + 6);
  double total = 0;
  for (const float intensity : intensities) total += intensity;
  ASSERT_EQ(combined.size(), octants[0].size());
  for (std::size_t i = 0; i < combined.count(); ++i) {
    double sum = 0;
    for (std::size_t s = 0; s < kOctants.size(); ++s) sum += static_cast<double>(intensities[s]) * octants[s].data()[i];
    ASSERT_NEAR(combined.data()[i], 65535 * sum / total, kBound) << i;
  }
}

TEST(CombinedVisibility, IsTheMeanOfTheOctantsByIntensity) {
  // Swept with the distance and through it, of opaque and translucent solids, the one number is what the eight float
  // octants sum to.
  const Grid<float> level = noiseLevel({37, 26, 31}, {1, 1.5, 0.8}, 3);
  for (const OctantIntensities& intensities : {kEvenOctants, kUneven})
    for (const float opacity : {1.0F, 0.4F}) {
      SweepOptions options{.visibility = VisibilityStorage::float32, .opacity = opacity, .intensities = intensities};
      const SweptFields octants = sweepOcclusion(level.view(), options);
      const GridView<const float> distance = octants.distance.view();
      const OctantVisibility alone = sweepVisibility(distance, VisibilityStorage::float32, opacity);
      options.visibility = VisibilityStorage::combined;
      expectMeanOf(octants.visibility.octants, intensities, sweepOcclusion(level.view(), options).visibility.combined);
      expectMeanOf(alone.octants, intensities,
                   sweepVisibility(distance, VisibilityStorage::combined, opacity, intensities).combined);
    }
}

TEST(CombinedVisibility, IsTheMeanBesideEdgesToo) {
  // Right behind the edges of walls, dark beside full light, the one number is that mean as well.
  const auto level = test::sampleLevel({60, 50, 40}, glm::dvec3(1), [](glm::dvec3 p) {
    return std::max(3.2 - std::abs(p.z - 20) + (p.x > 30 ? -9.0 : 0.0), 2.6 - std::abs(p.y - 14) + (p.z > 9 ? -9 : 0));
  });
  const OctantIntensities first{1, 0, 0, 0, 0, 0, 0, 0};
  for (const OctantIntensities& intensities : {kEvenOctants, first}) {
    SweepOptions options{.visibility = VisibilityStorage::float32, .intensities = intensities};
    const SweptFields octants = sweepOcclusion(level.view(), options);
    options.visibility = VisibilityStorage::combined;
    expectMeanOf(octants.visibility.octants, intensities, sweepOcclusion(level.view(), options).visibility.combined);
  }
}

TEST(CombinedVisibility, WithoutASolidIsFull) {
  // Where nothing is in the way the number is full to the last bit, whatever the intensities.
  Grid<float> level({19, 20, 21});
  std::fill_n(level.data(), level.count(), -1.0F);
  for (const OctantIntensities& intensities : {kEvenOctants, kUneven}) {
    const SweptFields fields = sweepOcclusion(std::as_const(level).view(),
                                              {.visibility = VisibilityStorage::combined, .intensities = intensities});
    for (std::size_t i = 0; i < level.count(); ++i) ASSERT_EQ(fields.visibility.combined.data()[i], 65535);
  }
}

}  // namespace
}  // namespace isolume
