// How --occlusion, --quality, --error and --ordinates come to a setting.
#include "src/jobs/occlusion_method.h"

#include <gtest/gtest.h>

#include "src/errors.h"

namespace isolume {
namespace {

// Errors: octants .10; 64 ordinates .0412 over two scenes, cheap; 256 .02, dear; 256 refined .015, dearer; 512 refined
// hardly better; 128 .03, dearer than 256.
const std::vector<CalibratedSetting> kCalibration = parseCalibration(R"({"settings": [
  {"occlusion": "octants", "occlusion-offset": 2, "seconds": 1, "scenes": [{"rmse": 0.1}]},
  {"occlusion": "ordinates", "ordinates": 64, "refinement": 1, "seconds": 2, "scenes": [{"rmse": 0.03}, {"rmse": 0.05}]},
  {"occlusion": "ordinates", "ordinates": 128, "refinement": 1, "seconds": 6, "scenes": [{"rmse": 0.03}]},
  {"occlusion": "ordinates", "ordinates": 256, "refinement": 1, "seconds": 5, "scenes": [{"rmse": 0.02}]},
  {"occlusion": "ordinates", "ordinates": 256, "refinement": 2, "seconds": 9, "scenes": [{"rmse": 0.015}]},
  {"occlusion": "ordinates", "ordinates": 512, "refinement": 2, "seconds": 99, "scenes": [{"rmse": 0.0149}]}]})");

OcclusionSetting choose(const OcclusionRequest& request) { return chooseOcclusion(request, kCalibration); }

TEST(OcclusionMethod, ErrorPicksTheCheapestSettingThatReachesIt) {
  // The RMSE over all scenes counts, whatever the method; a setting that is dearer and worse is never taken.
  EXPECT_EQ(choose({.error = 0.1}).method, OcclusionMethod::octants);
  EXPECT_EQ(choose({.error = 0.0999}).ordinates.ordinates, 64);
  EXPECT_EQ(choose({.error = 0.0413}).ordinates.ordinates, 64);
  EXPECT_EQ(choose({.error = 0.0412}).ordinates.ordinates, 256);
  EXPECT_EQ(choose({.error = 0.03}).ordinates.ordinates, 256);
  EXPECT_EQ(choose({.error = 0.03}).ordinates.refinement, 1);
  EXPECT_EQ(choose({.error = 0.015}).ordinates.refinement, 2);
  EXPECT_EQ(choose({.error = 0.015}).error, 0.015);
  EXPECT_EQ(choose({.error = 0.0149}).ordinates.ordinates, 512);
  EXPECT_THROW(choose({.error = 0.0148}), UsageError);
}

TEST(OcclusionMethod, MethodLimitsTheChoice) {
  // --occlusion ordinates never comes to octants, however large the error allowed.
  EXPECT_EQ(choose({.method = OcclusionMethod::ordinates, .error = 0.5}).ordinates.ordinates, 64);
}

TEST(OcclusionMethod, QualityIsABoundOnTheError) {
  // draft .05, good .02 and the default, best the least there is, unless nearly as good is cheaper.
  EXPECT_EQ(choose({.quality = OcclusionQuality::draft}).ordinates.ordinates, 64);
  EXPECT_EQ(choose({.quality = OcclusionQuality::good}).error, 0.02);
  EXPECT_EQ(choose({}).error, 0.02);
  EXPECT_EQ(choose({.quality = OcclusionQuality::best}).error, 0.015);
}

TEST(OcclusionMethod, TheShippedCalibrationKeepsTheDefaults) {
  // What is chosen by the calibration that the program carries is the default of the sweep itself, which `fields` and
  // README speak of.
  EXPECT_EQ(chooseOcclusion({}).ordinates.ordinates, OrdinateOptions().ordinates);
  EXPECT_EQ(chooseOcclusion({}).ordinates.refinement, OrdinateOptions().refinement);
}

TEST(OcclusionMethod, OrdinatesHaveTheErrorOfTheNextFewerOnes) {
  // A number between two calibrated ones states the error of the lower; below all of them none is stated.
  EXPECT_EQ(choose({.ordinates = 200}).error, 0.03);
  EXPECT_EQ(choose({.ordinates = 1000}).error, 0.02);
  EXPECT_EQ(choose({.ordinates = 300, .refinement = 2}).error, 0.015);
  EXPECT_EQ(choose({.ordinates = 63}).error, std::nullopt);
}

TEST(OcclusionMethod, OctantsStateTheirErrorAtTheCalibratedOffset) {
  // singh10 reads at the hit, octants two voxels above; elsewhere nothing was measured.
  EXPECT_EQ(choose({.method = OcclusionMethod::octants}).error, 0.1);
  EXPECT_EQ(choose({.method = OcclusionMethod::octants, .offset = 1}).error, std::nullopt);
  EXPECT_EQ(choose({.method = OcclusionMethod::singh10}).offset, 0);
}

TEST(OcclusionMethod, OpenPlaneTermsAreOfOctantsAndHaveTheirOwnError) {
  // Terms divided by what an open plane gives are stated in the settings, take the error that was measured with them,
  // and are refused beside methods without octants.
  const auto calibration = parseCalibration(R"({"settings": [
    {"occlusion": "octants", "occlusion-offset": 2, "seconds": 1, "scenes": [{"rmse": 0.1}]},
    {"occlusion": "octants", "occlusion-offset": 2, "octant-terms": "open-plane", "seconds": 1,
     "scenes": [{"rmse": 0.08}]}]})");
  const OcclusionSetting divided =
      chooseOcclusion({.method = OcclusionMethod::octants, .openPlane = true}, calibration);
  EXPECT_EQ(divided.error, 0.08);
  EXPECT_EQ(occlusionSettings(divided)["octant-terms"], "open-plane");
  const OcclusionSetting published = chooseOcclusion({.method = OcclusionMethod::octants}, calibration);
  EXPECT_EQ(published.error, 0.1);
  EXPECT_FALSE(occlusionSettings(published).contains("octant-terms"));
  EXPECT_EQ(choose({.method = OcclusionMethod::octants, .openPlane = true}).error, std::nullopt);
  EXPECT_THROW(choose({.openPlane = true}), UsageError);
  EXPECT_THROW(choose({.method = OcclusionMethod::combined, .openPlane = true}), UsageError);
}

TEST(OcclusionMethod, CalibrationOfTheProgramIsComplete) {
  // The embedded file has both octant methods and ordinates, with errors that make every quality a setting.
  for (const auto quality : {OcclusionQuality::draft, OcclusionQuality::good, OcclusionQuality::best})
    EXPECT_EQ(chooseOcclusion({.quality = quality}).method, OcclusionMethod::ordinates);
  EXPECT_TRUE(chooseOcclusion({.method = OcclusionMethod::singh10}).error);
  EXPECT_TRUE(chooseOcclusion({.method = OcclusionMethod::octants}).error);
}

TEST(OcclusionMethod, BrokenCalibrationIsAnError) {
  // No settings, an unknown method, a missing number.
  EXPECT_THROW(parseCalibration(R"({"settings": []})"), std::runtime_error);
  EXPECT_THROW(parseCalibration(R"({"settings": [{"occlusion": "magic"}]})"), std::runtime_error);
  EXPECT_THROW(parseCalibration(R"({"settings": [{"occlusion": "ordinates", "ordinates": 8}]})"), std::exception);
}

}  // namespace
}  // namespace isolume
