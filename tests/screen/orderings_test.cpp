// What the papers say of their estimators at few samples, on floors before walls: root mean square errors of single
// turns of the samples, over views, rolls and distances, against the mean of many samples of the same estimator.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "raymarch/screen/point_sets.h"
#include "screen/estimate.h"

namespace isolume::test {
namespace {

const std::array<glm::dvec3, 3> kViews{glm::dvec3(1, 1, -1), glm::dvec3(0.5, 0.2, -1), glm::dvec3(1, 0.6, -0.4)};
constexpr std::array kDistances{0.05, 0.15, 0.3, 0.5};

double singleError(const ScreenOcclusion& settings, const std::vector<glm::vec4>& samples) {
  constexpr int kRolls = 12;
  constexpr double kRoll = 0.7;  // radians; turns that do not repeat
  ScreenOcclusion many = settings;
  many.samples = kMostScreenSamples;
  double squares = 0;
  for (const glm::dvec3& view : kViews) {
    for (const double distance : kDistances) {
      const double truth = estimate(many, edge(distance), view, 16);
      for (int i = 0; i < kRolls; ++i)
        squares += std::pow(estimateBy(settings, samples, edge(distance), view, 1, i * kRoll) - truth, 2);
    }
  }
  return std::sqrt(squares / static_cast<double>(kRolls * kViews.size() * kDistances.size()));
}

double singleError(ScreenEstimator estimator, int samples) {
  const ScreenOcclusion settings{.estimator = estimator, .samples = samples};
  return singleError(settings, planScreen(settings).samples);
}

TEST(ScreenOrderings, VolumesBeatContainment) {
  // With as many samples, pipes through the tangent sphere err less than half as much as containment tests, whose
  // samples are 0 or 1 ([Szirmay10] Fig. 8, 9).
  for (const int samples : {4, 8, 12, 32})
    EXPECT_LT(singleError(ScreenEstimator::szirmayVolumetric, samples),
              singleError(ScreenEstimator::szirmayContainment, samples) / 2)
        << samples;
}

TEST(ScreenOrderings, FiveLinesAreWorthTwelvePoints) {
  // Five lines err no more than twelve points, up to a tenth ([Loos10] Sec. 5.1).
  EXPECT_LT(singleError(ScreenEstimator::loosLine, 5), 1.1 * singleError(ScreenEstimator::loosPoint, 12));
}

TEST(ScreenOrderings, PoissonDisksBeatChance) {
  // Containment tests at Poisson-disk samples err less than at independent ones, for the same integral.
  for (const int samples : {8, 12, 32})
    EXPECT_LT(singleError(ScreenEstimator::szirmayContainment, samples),
              singleError(ScreenEstimator::gpuImportance, samples))
        << samples;
}

/// Root mean square of the error of four pipes over sets of samples.
template <class Points>
double errorOfFourPipes(bool normalised, Points points) {
  constexpr int kFew = 4, kSets = 8;
  ScreenOcclusion settings{.samples = kFew, .normalisedBySamples = normalised};
  double squares = 0;
  for (int seed = 0; seed < kSets; ++seed) {
    std::vector<glm::vec4> samples;
    double chords = 0;
    for (const auto& p : points(kFew, static_cast<std::uint64_t>(seed))) {
      samples.emplace_back(p.x, p.y, std::sqrt(1 - p.x * p.x - p.y * p.y), 0);
      chords += samples.back().z;
    }
    // [Szirmay10] Eq. 7 with R = 1: F by the samples, or exact.
    for (glm::vec4& each : samples) each.w = static_cast<float>(1 / (normalised ? chords : 2.0 * kFew / 3));
    squares += std::pow(singleError(settings, samples), 2);
  }
  return std::sqrt(squares / kSets);
}

TEST(ScreenOrderings, FourSamplesNormaliseThemselves) {
  // With four samples as dart throwing leaves them, dividing by the sampled volume errs less than by the exact one
  // ([Szirmay10] Fig. 10). With radii of rings of equal area, as this program takes them, the sampled volume is nearly
  // the exact one, and both err less than either does without.
  const auto thrown = [](int count, std::uint64_t seed) { return scatteredPoints(count, true, seed); };
  const auto rings = [](int count, std::uint64_t seed) { return poissonDisk(count, seed); };
  const double thrownExact = errorOfFourPipes(false, thrown), thrownSampled = errorOfFourPipes(true, thrown);
  const double ringsExact = errorOfFourPipes(false, rings), ringsSampled = errorOfFourPipes(true, rings);
  EXPECT_LT(thrownSampled, thrownExact);
  EXPECT_NEAR(ringsSampled, ringsExact, ringsExact / 10);
  EXPECT_LT(ringsSampled, thrownSampled);
}

}  // namespace
}  // namespace isolume::test
