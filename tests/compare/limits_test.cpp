// When a comparison fails.
#include "src/compare/limits.h"

#include <gmock/gmock.h>

#include "compare/pictures.h"
#include "src/errors.h"
#include "support/temp_folder.h"

namespace isolume::test {
namespace {

using ::testing::HasSubstr;

/// 20 pixels, all off by -1/8 but one, which is off by 1/2.
Comparison known() {
  std::vector<float> values(20, -0.125f);
  values[3] = 0.5f;
  Image got = picture({20, 1}, values), want = picture({20, 1}, std::vector<float>(20));
  return compare(got, want);
}

struct Limit {
  std::optional<double> CompareLimits::*member;
  double keeps, breaks;
  const char* name;
};

TEST(Limits, EachMeasureHasItsLimit) {
  // Every limit holds at the value itself and is broken by the next smaller number, which names the measure and both.
  const Comparison c = known();
  const Measures& m = c.measures[0].measures;
  EXPECT_LT(m.bias, 0);  // so that the limit on bias is seen to be one on its magnitude
  const auto below = [](double v) { return std::nextafter(v, -1.0); };
  const Limit limits[] = {{&CompareLimits::maxRmse, m.rmse, below(m.rmse), "ambient.Y RMSE: expected at most"},
                          {&CompareLimits::maxBias, -m.bias, below(-m.bias), "ambient.Y |bias|: expected at most"},
                          {&CompareLimits::maxMean, m.mean, below(m.mean), "ambient.Y mean: expected at most"},
                          {&CompareLimits::maxP95, m.p95, below(m.p95), "ambient.Y 95th percentile: expected at most"},
                          {&CompareLimits::maxError, m.max, below(m.max), "ambient.Y maximum: expected at most"},
                          {&CompareLimits::minSsim, *c.ssim, std::nextafter(*c.ssim, 2), "SSIM: expected at least"}};
  EXPECT_EQ(brokenLimits(c, {}), "");
  for (const Limit& limit : limits) {
    CompareLimits one;
    one.*limit.member = limit.keeps;
    EXPECT_EQ(brokenLimits(c, one), "") << limit.name;
    one.*limit.member = limit.breaks;
    EXPECT_THAT(brokenLimits(c, one), HasSubstr(limit.name));
  }
}

TEST(Limits, MissesHaveTheirs) {
  // A share of misses above the limit is broken, at the limit it is kept.
  Image got = picture({4, 1}, {0, 0, 0, 0}), want = got;
  channelOf(got, "Z")[2] = kInf;
  const Comparison c = compare(got, want);
  EXPECT_EQ(brokenLimits(c, {.maxMiss = 0.25}), "");
  EXPECT_EQ(brokenLimits(c, {.maxMiss = 0.125}),
            "got.exr against want.exr: share hit by one only: expected at most 0.125, found 0.25");
}

TEST(Limits, AllThatIsBrokenStandsInOneLine) {
  // Several broken limits and a NaN: one line with each of them.
  Image got = picture({3, 1}, {0.5f, kNan, 0.5f});
  const std::string line =
      brokenLimits(compare(got, picture({3, 1}, {0, 0, 0})), {.maxRmse = 0.25, .maxBias = 0.25, .maxMean = 0.75});
  EXPECT_EQ(
      line,
      "got.exr against want.exr: ambient: expected finite values where something is hit, found 1 NaN and 0 infinite, "
      "the first in got.exr at pixel (1, 0); ambient.Y RMSE: expected at most 0.25, found 0.5; ambient.Y |bias|: "
      "expected at most 0.25, found 0.5");
}

TEST(Limits, WhatCannotBeMeasuredIsBroken) {
  // Pictures without a pixel in common keep no limit on a measure, but one on misses if neither hits anything.
  Image miss = picture({2, 1}, {0, 0});
  channelOf(miss, "Z") = {kInf, kInf};
  const Comparison c = compare(miss, miss);
  EXPECT_EQ(brokenLimits(c, {.maxMiss = 0.0}), "");
  for (const auto member : {&CompareLimits::maxRmse, &CompareLimits::maxBias, &CompareLimits::maxMean,
                            &CompareLimits::maxP95, &CompareLimits::maxError}) {
    CompareLimits limits;
    limits.*member = 1000;
    EXPECT_THAT(brokenLimits(c, limits), HasSubstr("found no pixel to compare"));
  }
  EXPECT_THAT(brokenLimits(c, {.minSsim = -1.0}), HasSubstr("found too few pixels"));
}

TEST(Limits, VectorsAreLimitedInDegreesOthersPerChannel) {
  // A limit of 1 on normals 90 degrees apart speaks of the angle alone; on two plain channels it speaks of each.
  Image got = picture({1, 1}, {0}), want = got;
  addVectors(got, "normal", {{1, 0, 0}});
  addVectors(want, "normal", {{0, 1, 0}});
  EXPECT_EQ(brokenLimits(compare(got, want, "normal"), {.maxRmse = 0.5}),
            "got.exr against want.exr: angle RMSE: expected at most 0.5, found 90");
  for (const char* name : {"sky.R", "sky.G"}) {
    got.channels.push_back({name, {1}});
    want.channels.push_back({name, {0}});
  }
  const std::string both = brokenLimits(compare(got, want, "sky"), {.maxRmse = 0.5});
  EXPECT_THAT(both, HasSubstr("sky.R RMSE"));
  EXPECT_THAT(both, HasSubstr("sky.G RMSE"));
  EXPECT_THAT(messageOf<UsageError>([&] { shownDifference(pairOf(got, want, "sky")); }),
              HasSubstr("--layer sky.R, found 2 channels"));
}

}  // namespace
}  // namespace isolume::test
