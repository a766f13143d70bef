// ssdo and environment importance sampling under a sky, against integrals over what is open.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "raymarch/screen/sky_draws.h"
#include "screen/estimate.h"

namespace isolume::test {
namespace {

using std::numbers::pi;

constexpr glm::vec3 kLuminance{0.2126f, 0.7152f, 0.0722f};
const std::array kEstimators{ScreenEstimator::ssdo, ScreenEstimator::envImportance};
const glm::dvec3 kView(1, 0.6, -0.4);

/// Radiance of a bright warm lobe over a dim blue that lightens towards +y.
glm::dvec3 radiance(glm::dvec3 w) {
  const double lobe = std::pow(std::max(glm::dot(w, glm::normalize(glm::dvec3(-0.5, 0.3, 0.8))), 0.0), 8);
  return lobe * glm::dvec3(4, 2, 1) + (1 + w.y) * glm::dvec3(0.1, 0.2, 0.6);
}

glm::dvec3 texelDirection(const SkyCube& sky, std::size_t i) {
  const auto edge = static_cast<std::size_t>(sky.side), texel = i % (edge * edge);
  return cubeDirection(sky.side, static_cast<int>(i / (edge * edge)),
                       {static_cast<double>(texel % edge) + 0.5, static_cast<double>(texel / edge) + 0.5});
}

std::shared_ptr<const SkyCube> lobeSky() {
  auto sky = std::make_shared<SkyCube>();
  for (std::size_t i = 0; i < sky->radiance.size(); ++i) sky->radiance[i] = radiance(texelDirection(*sky, i));
  return sky;
}

/// (1 / pi) integral of L V cos dw, with how much of a direction that meets the wall at x = a at a distance is open.
template <class Open>
glm::dvec3 lightBeforeWall(double a, Open open) {
  constexpr int kDirections = 200000;
  glm::dvec3 sum(0);
  for (int i = 0; i < kDirections; ++i) {
    const double z = std::sqrt((i + 0.5) / kDirections), turn = 2 * pi * i / std::numbers::phi;
    const glm::dvec3 w(std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn), z);
    sum += (w.x > a ? open(a / w.x) : 1.0) * radiance(w);
  }
  return sum / static_cast<double>(kDirections);
}

ScreenOcclusion many(ScreenEstimator estimator) {
  return {.estimator = estimator, .samples = kMostScreenSamples, .sky = lobeSky()};
}

// Of 256 samples in 32 turns, times the brightest radiance that a sample of ssdo weighs, about 4.
constexpr double kSetError = 0.05;

TEST(SkyLight, WallAtADistance) {
  // Before a wall each estimator gives the light of the sky from where it is open: ssdo with what it closes growing as
  // 1 - D, importance sampling with all of it.
  for (const ScreenEstimator estimator : kEstimators)
    for (const double a : {0.0, 0.2, 0.5, 2.0}) {
      const glm::dvec3 want = lightBeforeWall(a, [&](double d) {
        return estimator == ScreenEstimator::ssdo ? std::min(d, 1.0) : d < 1 ? 0.0 : 1.0;
      });
      const glm::dvec4 got = estimateLight(many(estimator), edge(a), kView);
      EXPECT_LT(glm::distance(glm::dvec3(got), want), kSetError) << screenEstimatorName(estimator) << " at " << a;
    }
}

TEST(SkyLight, ExactNormalisationIsTheSame) {
  // Divided by the exact light in place of the sampled one both give the same.
  for (ScreenEstimator estimator : kEstimators) {
    ScreenOcclusion settings = many(estimator);
    const glm::dvec4 sampled = estimateLight(settings, edge(0.3), kView);
    settings.normalisedBySamples = false;
    EXPECT_LT(glm::distance(sampled, estimateLight(settings, edge(0.3), kView)), kSetError);
  }
}

TEST(SkyLight, OpennessIsThatWithoutASky) {
  // Beside its light ssdo tells the openness that it has without a sky; a white sky gives just that as light.
  ScreenOcclusion settings = many(ScreenEstimator::ssdo);
  ScreenOcclusion plain = settings;
  plain.sky.reset();
  const double openness = estimate(plain, edge(0.3), kView);
  EXPECT_NEAR(estimateLight(settings, edge(0.3), kView).w, openness, 1e-5);
  auto white = std::make_shared<SkyCube>();
  addEvenSky(*white, glm::vec3(1));
  settings.sky = white;
  const glm::dvec4 light = estimateLight(settings, edge(0.3), kView);
  EXPECT_NEAR(light.r, openness, 1e-5);
  EXPECT_NEAR(light.b, openness, 1e-5);
}

TEST(SkyLight, ImportanceBeatsEvenDirections) {
  // Under a bright lobe single turns of eight directions drawn by luminance and cosine err less than half as much as
  // even ones, each against its own mean.
  const auto error = [](ScreenEstimator estimator) {
    ScreenOcclusion settings = many(estimator);
    const glm::dvec4 truth = estimateLight(settings, edge(0.5), kView);
    settings.samples = 8;
    double squares = 0;
    constexpr int kRolls = 16;
    for (int i = 0; i < kRolls; ++i)
      squares += std::pow(glm::distance(estimateLight(settings, edge(0.5), kView, 1, i), truth), 2);
    return std::sqrt(squares / kRolls);
  };
  EXPECT_LT(error(ScreenEstimator::envImportance), error(ScreenEstimator::ssdo) / 2);
}

TEST(SkyDraws, FollowTheLuminance) {
  // Powers add up to the sky's luminance; draws lie within their cell, have colours of luminance 1, and in each cell
  // their mean of any function is that of the cell weighed by luminance, to the step between sixteen strata.
  const auto sky = lobeSky();
  const std::vector<glm::vec4> table = skyDraws(*sky);
  const std::vector<double> angles = cubeSolidAngles(sky->side);
  std::array<double, kSkyCells> power{};
  std::array<glm::dvec3, kSkyCells> moment{};
  for (std::size_t i = 0; i < sky->radiance.size(); ++i) {
    const glm::dvec3 w = texelDirection(*sky, i);
    const double light = angles[i % angles.size()] * glm::dot(sky->radiance[i], kLuminance);
    power[cubeTexel(kCellsAlong, w)] += light;
    moment[cubeTexel(kCellsAlong, w)] += light * w;
  }
  for (std::size_t cell = 0; cell < kSkyCells; ++cell) {
    const glm::vec4* row = &table[cell * (1 + 2 * kCellDraws)];
    EXPECT_NEAR(row[0].w, power[cell], 1e-4 * power[cell]);
    EXPECT_EQ(cubeTexel(kCellsAlong, glm::dvec3(row[0])), cell);
    glm::dvec3 mean(0);
    for (int draw = 0; draw < kCellDraws; ++draw) {
      const glm::vec3 w(row[1 + 2 * draw]), color(row[2 + 2 * draw]);
      EXPECT_EQ(cubeTexel(kCellsAlong, glm::dvec3(w)), cell);
      EXPECT_NEAR(glm::dot(color, kLuminance), 1, 1e-5);
      mean += glm::dvec3(w) / static_cast<double>(kCellDraws);
    }
    EXPECT_LT(glm::distance(mean, moment[cell] / power[cell]), 0.06) << cell;
  }
  SkyCube black;
  for (const glm::vec4& texel : skyDraws(black)) EXPECT_EQ(texel.w, 0);
}

}  // namespace
}  // namespace isolume::test
