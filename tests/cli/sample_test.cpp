#include <gmock/gmock.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "cli/picture.h"
#include "cli/program.h"
#include "volumes/scenes.h"

namespace isolume::test {
namespace {

using ::testing::HasSubstr;

TEST_F(ProgramTest, RawSamplesAreThoseOfTheScene) {
  // For every scene the raw file holds the samples of sampleScene(), bit for bit, and can be read back by its name.
  constexpr int kSize = 12;
  for (const std::string_view name : sceneNames()) {
    const std::string file = std::string(name) + "_12x12x12_float32.raw";
    runWell({"sample", std::string(name), "--size", "12", "--quiet", "-o", file});
    const std::string bytes = fileBytes(path(file));
    const Grid<float> grid = sampleScene(*findScene(name), kSize);
    ASSERT_EQ(bytes.size(), grid.count() * sizeof(float));
    EXPECT_EQ(std::memcmp(bytes.data(), grid.data(), bytes.size()), 0) << name;
    EXPECT_THAT(runWell({"info", file}).out, HasSubstr("12 x 12 x 12"));
  }
}

TEST_F(ProgramTest, VdbSamplesStandInTheUnitCube) {
  // Voxel centres lie at (i + 1/2) / N of the world; scenes with exact distance are level sets, others are not.
  for (const std::string_view name : sceneNames()) {
    runWell({"sample", std::string(name), "--size", "20", "--quiet", "-o", "scene.vdb"});
    const auto info = nlohmann::json::parse(runWell({"info", "scene.vdb", "--json"}).out);
    EXPECT_EQ(info["grids"][0]["kind"] == "level set", findScene(name)->exactDistance) << name;
    constexpr double kRounding = 1e-12;  // of a few operations on numbers near 1
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(info["spacing"][axis].get<double>(), 1.0 / 20, kRounding);
      const double offset = info["origin"][axis].get<double>() * 20 - 0.5;
      EXPECT_NEAR(offset, std::round(offset), 20 * kRounding) << name;
    }
  }
}

TEST_F(ProgramTest, SampleSaysHowToDrawIt) {
  // The command that `sample` prints works as it stands, also for a raw file whose name says nothing.
  for (const std::string output : {"gyroid.vdb", "gyroid.raw", "gyroid_16x16x16_float32.raw"}) {
    const std::string told = runWell({"sample", "gyroid", "--size", "16", "-o", output}).out;
    const std::string key = "draw it with: isolume ";
    ASSERT_THAT(told, HasSubstr(key));
    std::vector<std::string> command = words(told.substr(told.find(key) + key.size()));
    command.insert(command.end(), {"--size", "8x8"});
    runWell(command);
    EXPECT_EQ(readImage(path("gyroid.png")).size, glm::ivec2(8, 8));
  }
}

}  // namespace
}  // namespace isolume::test
