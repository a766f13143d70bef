// Saved fields: what they hold, and that drawing from them is drawing from the volume.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "cli/picture.h"
#include "cli/program.h"
#include "src/io/vdb.h"

namespace isolume::test {
namespace {

using ::testing::HasSubstr;

class Fields : public ProgramTest {
 protected:
  Fields() {
    runWell({"sample", "corner", "--size", "24", "--quiet", "-o", "corner.vdb"});
    runWell(
        {"fields", "corner.vdb", "--isovalue", "0.01", "--inside", "below", "--report", "fields.json", "-o", "f.vdb"});
  }
};

/// The file's octants are exact floats, rounded to bytes when they are drawn; those of the volume are swept in 16-bit
/// lanes, off by .0007 at most. So a byte may be one step off, here and there: what is lit by them differs by so much
/// at most, and hardly on the mean; all else has the same bits.
void expectOctantsAlike(const Image& a, const Image& b) {
  constexpr double kLargest = 1.0 / 255 + 7e-4, kMean = 3e-4;
  ASSERT_EQ(channelNames(a), channelNames(b));
  for (const std::string& name : channelNames(a)) {
    const std::vector<float>&x = channel(a, name), &y = channel(b, name);
    const bool lit = name == "R" || name == "G" || name == "B" || name == "ambient.Y";
    double sum = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      if (!lit) {
        ASSERT_EQ(std::memcmp(&x[i], &y[i], sizeof(float)), 0) << name << " at " << i;
      } else {
        ASSERT_NEAR(x[i], y[i], kLargest) << name << " at " << i;
        sum += std::abs(static_cast<double>(x[i]) - static_cast<double>(y[i]));
      }
    }
    EXPECT_LT(sum / static_cast<double>(x.size()), kMean) << name;
  }
}

TEST_F(Fields, DrawThePictureOfTheVolume) {
  // A picture drawn from a fields file, without a sweep, is that of the volume but for the rounding of its octants.
  const std::vector<std::string> look{"--size", "37x29", "--layers", "all", "--azimuth", "50"};
  std::vector<std::string> direct{"render", "corner.vdb", "--isovalue", "0.01",        "--inside",
                                  "below",  "-o",         "direct.exr", "--occlusion", "octants"};
  std::vector<std::string> saved{"render", "f.vdb", "--report", "saved.json", "-o", "saved.exr"};
  for (std::vector<std::string>* command : {&direct, &saved}) {
    command->insert(command->end(), look.begin(), look.end());
    runWell(*command);
  }
  const Image image = readImage(path("saved.exr"));
  expectOctantsAlike(readImage(path("direct.exr")), image);
  EXPECT_THAT(metadata(image, "isolume:fields_source"), HasSubstr("isolume fields corner.vdb --isovalue 0.01"));
  EXPECT_EQ(metadata(image, "isolume:isovalue"), "0.01");
  const auto report = nlohmann::json::parse(fileBytes(path("saved.json")));
  EXPECT_EQ(report["stages"][1]["name"], "upload") << "fields were swept again";
}

TEST_F(Fields, AlsoServeOrdinates) {
  // Asked for ordinates, a fields file gives the picture of the volume: only the openness is swept.
  runWell({"render", "corner.vdb", "--isovalue", "0.01", "--inside", "below", "--occlusion", "ordinates", "--size",
           "20x20", "--layers", "all", "-o", "direct.exr"});
  runWell({"render", "f.vdb", "--occlusion", "ordinates", "--size", "20x20", "--layers", "all", "-o", "saved.exr"});
  EXPECT_TRUE(sameBits(readImage(path("direct.exr")), readImage(path("saved.exr"))));
}

TEST_F(Fields, AlsoServeLights) {
  // Lights that octants do not have are swept through a file of fields without further words.
  runWell({"render", "f.vdb", "--light", "gradient:zenith=red", "--size", "20x20", "-o", "lit.exr"});
  EXPECT_THAT(metadata(readImage(path("lit.exr")), "isolume:settings"), HasSubstr("--occlusion ordinates"));
}

TEST_F(Fields, MayHoldMoreForOtherPrograms) {
  // Openness, bent normals and thickness are grids of their own, with values within their ranges next to the surface;
  // the picture from the file does not change.
  runWell({"fields", "corner.vdb", "--isovalue", "0.01", "--inside", "below", "--with", "openness,bent,thickness", "-o",
           "more.vdb"});
  const Volume openness = readVdb(path("more.vdb"), "openness"), cone = readVdb(path("more.vdb"), "cone");
  const Volume thickness = readVdb(path("more.vdb"), "thickness");
  std::array<Volume, 3> bent{readVdb(path("more.vdb"), "bent_x"), readVdb(path("more.vdb"), "bent_y"),
                             readVdb(path("more.vdb"), "bent_z")};
  std::size_t near = 0;
  for (std::size_t i = 0; i < openness.values.count(); ++i) {
    const auto at = [i](const Volume& volume) { return volume.values.data()[i]; };
    const double length = std::hypot(at(bent[0]), at(bent[1]), at(bent[2]));
    ASSERT_TRUE(length == 0 || std::abs(length - 1) < 1e-5) << i;
    ASSERT_TRUE(at(openness) >= 0 && at(openness) <= 1 && at(cone) >= 0 && at(cone) <= 1.5708F) << i;
    ASSERT_EQ(at(cone) > 0 && length == 0, false) << i;
    near += length > 0 && at(openness) > 0 ? 1 : 0;
  }
  EXPECT_GT(near, 1000U);
  EXPECT_GT(*std::max_element(thickness.values.data(), thickness.values.data() + thickness.values.count()), 0);
  for (const char* file : {"f.vdb", "more.vdb"})
    runWell({"render", file, "--size", "20x20", "-o", std::string(file) + ".exr"});
  EXPECT_EQ(channel(readImage(path("f.vdb.exr")), "R"), channel(readImage(path("more.vdb.exr")), "R"));
}

TEST_F(Fields, AlsoDrawWithoutOcclusion) {
  // A fields file serves a head light too, with the bits of the volume itself.
  runWell({"render", "corner.vdb", "--isovalue", "0.01", "--inside", "below", "--occlusion", "none", "--size", "20x20",
           "-o", "direct.exr"});
  runWell({"render", "f.vdb", "--occlusion", "none", "--size", "20x20", "-o", "saved.exr"});
  EXPECT_TRUE(sameBits(readImage(path("direct.exr")), readImage(path("saved.exr"))));
}

TEST_F(Fields, HoldTheDistanceOfTheSolver) {
  // --solver changes the distances that are saved, and a picture drawn from them is the one drawn with that solver.
  runWell({"fields", "corner.vdb", "--isovalue", "0.01", "--inside", "below", "--solver", "closest", "-o", "c.vdb"});
  EXPECT_NE(fileBytes(path("c.vdb")).size(), 0u);
  runWell({"render", "c.vdb", "--size", "20x20", "--layers", "all", "-o", "saved.exr"});
  runWell({"render", "corner.vdb", "--isovalue", "0.01", "--inside", "below", "--solver", "closest", "--size", "20x20",
           "--layers", "all", "--occlusion", "octants", "-o", "direct.exr"});
  expectOctantsAlike(readImage(path("direct.exr")), readImage(path("saved.exr")));
  // 24 samples along a side of 1: some distance differs by a tenth of a voxel.
  const Volume closest = readVdb(path("c.vdb"), "distance"), swept = readVdb(path("f.vdb"), "distance");
  ASSERT_EQ(closest.values.count(), swept.values.count());
  float largest = 0;
  for (std::size_t i = 0; i < swept.values.count(); ++i)
    largest = std::max(largest, std::abs(closest.values.data()[i] - swept.values.data()[i]));
  EXPECT_GT(largest, 0.1F / 24);
  EXPECT_THAT(metadata(readImage(path("direct.exr")), "isolume:settings"), HasSubstr("--solver closest"));
}

TEST_F(Fields, HoldTheStartOfTheSweep) {
  // --start changes the picture, --extent does not: visibility needs no distance beyond the band.
  const auto draw = [&](const std::vector<std::string>& options, const std::string& name) {
    std::vector<std::string> words{"render", "corner.vdb", "--isovalue", "0.01",     "--inside",
                                   "below",  "--size",     "20x20",      "--layers", "all"};
    words.insert(words.end(), options.begin(), options.end());
    words.insert(words.end(), {"-o", name});
    runWell(words);
    return readImage(path(name));
  };
  const Image band = draw({"--solver", "closest"}, "band.exr");
  EXPECT_TRUE(sameBits(band, draw({"--solver", "closest", "--extent", "full"}, "full.exr")));
  const Image better = draw({}, "better.exr");
  const Image paper = draw({"--start", "paper"}, "paper.exr");
  EXPECT_FALSE(sameBits(better, paper));
  EXPECT_TRUE(sameBits(better, draw({"--solver", "godunov", "--start", "better", "--extent", "band"}, "said.exr")));
  // Nor do slopes of the distance, for which the band is thicker.
  const Image slopes = draw({"--normals", "distance"}, "slopes.exr");
  EXPECT_FALSE(sameBits(better, slopes));
  EXPECT_TRUE(sameBits(slopes, draw({"--normals", "distance", "--extent", "full"}, "slopes_full.exr")));
  EXPECT_THAT(metadata(paper, "isolume:settings"), HasSubstr("--solver godunov --start paper --extent band"));
}

TEST_F(Fields, RefuseAStartThatTheSolverDoesNotHave) {
  // Closest points start from no distances: --start beside them is a usage error that says so, and nothing is written.
  const Outcome outcome = run({"render", "corner.vdb", "--isovalue", "0.01", "--inside", "below", "--solver", "closest",
                               "--start", "paper", "-o", "refused.png"});
  EXPECT_EQ(outcome.exitCode, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--start: expected --solver godunov"));
  EXPECT_FALSE(std::filesystem::exists(path("refused.png")));
}

TEST_F(Fields, HaveTheirStagesInTheReport) {
  // Making fields reads, sweeps and writes, and draws nothing.
  const auto report = nlohmann::json::parse(fileBytes(path("fields.json")));
  std::vector<std::string> names;
  for (const auto& stage : report["stages"]) names.push_back(stage["name"]);
  EXPECT_THAT(names, ::testing::ElementsAre("read", "distance", "visibility", "write"));
  EXPECT_GE(report["voxels"].get<std::size_t>(), std::size_t{24 * 24 * 24});
}

TEST_F(Fields, LeaveNoChoiceOfSurface) {
  // Options that choose another surface, and sweeping fields again, are usage errors that name the file.
  for (const auto& [option, value] : {std::pair{"--isovalue", "0.2"},
                                      {"--inside", "above"},
                                      {"--grid", "distance"},
                                      {"--solver", "closest"},
                                      {"--start", "paper"},
                                      {"--extent", "full"}}) {
    const Outcome outcome = run({"render", "f.vdb", option, value, "-o", "out.png"});
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_THAT(outcome.err, HasSubstr(option));
    EXPECT_THAT(outcome.err, HasSubstr("f.vdb"));
  }
  EXPECT_EQ(run({"fields", "f.vdb", "-o", "again.vdb"}).exitCode, 2);
}

TEST_F(Fields, AreNamedByInfo) {
  // info tells a fields file, its ten grids, its isovalue and how it was made.
  const std::string text = runWell({"info", "f.vdb"}).out;
  for (const char* part : {"VDB fields", "level", "distance", "visibility_nnn", "visibility_ppp",
                           "isovalue 0.01, inside below", "isolume fields corner.vdb"})
    EXPECT_THAT(text, HasSubstr(part));
}

}  // namespace
}  // namespace isolume::test
