// How a picture says how it was made, and the report.
#include <gmock/gmock.h>

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

#include "cli/picture.h"
#include "cli/program.h"
#include "src/io/checksum.h"
#include "src/version.h"

namespace isolume::test {
namespace {

using ::testing::HasSubstr;

constexpr int kBall = 17, kRadius = 6;
const std::string kBallFile = "ball_17x17x17_float32.raw";
constexpr std::size_t kVoxels = 17 * 17 * 17;

class Provenance : public ProgramTest {
 protected:
  Provenance() { writeBall(path(kBallFile), kBall, kRadius); }
};

// Those with any of the 26 around them on the other side: they hold the openness.
int samplesNextToTheBall() {
  const auto isSolid = [](glm::ivec3 at) {
    const glm::ivec3 from = at - kBall / 2;
    return from.x * from.x + from.y * from.y + from.z * from.z < kRadius * kRadius;
  };
  int count = 0;
  for (int i = 0; i < static_cast<int>(kVoxels); ++i) {
    const glm::ivec3 at(i % kBall, i / kBall % kBall, i / kBall / kBall);
    bool isNext = false;
    for (int k = 0; k < 27; ++k) isNext |= isSolid(at + glm::ivec3(k % 3, k / 3 % 3, k / 9) - 1) != isSolid(at);
    count += isNext ? 1 : 0;
  }
  return count;
}

TEST_F(Provenance, PngAndExrSayHowTheyWereMade) {
  // Command, version, input with checksum, isovalue, side, camera, settings, backend and GL are in both formats.
  for (const std::string output : {"out.png", "out.exr"}) {
    runWell({"render", kBallFile, "--isovalue", "0.25", "--size", "24x16", "-o", output});
    const Image image = readImage(path(output));
    EXPECT_EQ(metadata(image, "isolume:command"),
              "isolume render " + kBallFile + " --isovalue 0.25 --size 24x16 -o " + output);
    EXPECT_EQ(metadata(image, "isolume:version"), kVersion);
    EXPECT_EQ(metadata(image, "Software"), "isolume " + std::string(kVersion));
    EXPECT_EQ(metadata(image, "isolume:input"), kBallFile);
    EXPECT_EQ(metadata(image, "isolume:input_sha256"), sha256OfFile(path(kBallFile)) + "  " + kBallFile);
    EXPECT_EQ(metadata(image, "isolume:isovalue"), "0.25");
    EXPECT_EQ(metadata(image, "isolume:inside"), "above");
    EXPECT_THAT(metadata(image, "isolume:camera"), HasSubstr("--projection perspective --fov 30"));
    EXPECT_THAT(metadata(image, "isolume:settings"),
                HasSubstr("--size 24x16 --samples 1 --occlusion ordinates --ordinates "));
    EXPECT_THAT(metadata(image, "isolume:backend"), ::testing::AnyOf("osmesa", "egl"));
    EXPECT_THAT(metadata(image, "isolume:gl"), ::testing::Not(""));
  }
}

TEST_F(Provenance, MetadataDrawsThePictureAgain) {
  // Isovalue, side, camera and settings taken from a picture, as options, give it again to the last bit.
  runWell({"render",   kBallFile,     "--azimuth",    "33.3",    "--elevation",  "-12.7",
           "--roll",   "5",           "--zoom",       "1.3",     "--gamma",      "2.2",
           "--albedo", "0.9,0.7,0.1", "--background", "#123456", "--normals",    "distance",
           "--size",   "31x27",       "--samples",    "3",       "--layers",     "normal,depth",
           "-o",       "first.exr",   "--ordinates",  "40",      "--refinement", "2"});
  const Image first = readImage(path("first.exr"));
  std::vector<std::string> again{"render", metadata(first, "isolume:input"), "-o", "again.exr"};
  for (const char* key : {"isolume:camera", "isolume:settings"})
    for (const std::string& word : words(metadata(first, key))) again.push_back(word);
  for (const auto& [option, key] : {std::pair{"--isovalue", "isolume:isovalue"}, {"--inside", "isolume:inside"}}) {
    again.push_back(option);
    again.push_back(metadata(first, key));
  }
  runWell(again);
  EXPECT_TRUE(sameBits(first, readImage(path("again.exr"))));
}

TEST_F(Provenance, ReportHasStagesMemoryAndSettings) {
  // The JSON has the six stages in order with seconds and bytes, the voxels, the peak memory and every setting.
  runWell({"render", kBallFile, "--isovalue", "0", "--size", "24x16", "--threads", "1", "--report", "report.json", "-o",
           "out.png"});
  const auto report = nlohmann::json::parse(fileBytes(path("report.json")));
  std::vector<std::string> names;
  for (const auto& stage : report["stages"]) {
    names.push_back(stage["name"]);
    EXPECT_GE(stage["seconds"].get<double>(), 0) << stage;
    EXPECT_GT(stage["bytes"].get<std::size_t>(), 0u) << stage;
  }
  EXPECT_THAT(names, ::testing::ElementsAre("read", "distance", "visibility", "upload", "frame", "write"));
  EXPECT_EQ(report["stages"][0]["bytes"], kVoxels * sizeof(float));
  // A bit and a count for each word of the rows, which are longer by one sample at each end, and the numbers.
  EXPECT_EQ(report["stages"][2]["bytes"], 19 * 19 * (8 + 4) + 2 * samplesNextToTheBall());
  EXPECT_GT(report["stages"][2]["seconds"], 0);
  EXPECT_EQ(report["stages"][5]["bytes"], fileBytes(path("out.png")).size());
  EXPECT_EQ(report["voxels"], kVoxels);
  EXPECT_EQ(report["dims"], nlohmann::json({17, 17, 17}));
  EXPECT_EQ(report["threads"], 1);
  EXPECT_GT(report["peak_rss_bytes"].get<std::size_t>(), kVoxels * sizeof(float));
  EXPECT_EQ(report["input"]["path"], kBallFile);
  EXPECT_EQ(report["settings"]["size"], "24x16");
  EXPECT_EQ(report["settings"]["occlusion"], "ordinates");
  EXPECT_GT(report["settings"]["calibrated_error"], 0);
  EXPECT_EQ(report["settings"]["solver"], "godunov");
  EXPECT_EQ(report["settings"]["start"], "better");
  EXPECT_EQ(report["settings"]["extent"], "band");
  for (const char* key : {"isovalue", "isovalue_choice", "inside", "samples", "normals", "gamma", "albedo",
                          "background", "camera", "backend", "gl"})
    EXPECT_TRUE(report["settings"].contains(key)) << key;
}

TEST_F(Provenance, VisibilityOfOctantsHasTimeAndMemoryOfItsOwn) {
  // With octants and --extent full the distance and the eight octants' bytes are stages of their own.
  runWell({"render", kBallFile, "--occlusion", "octants", "--extent", "full", "--size", "24x16", "--report",
           "report.json", "-o", "out.png"});
  const auto report = nlohmann::json::parse(fileBytes(path("report.json")));
  EXPECT_EQ(report["stages"][2]["name"], "visibility");
  EXPECT_GT(report["stages"][2]["seconds"], 0);
  EXPECT_EQ(report["stages"][2]["bytes"], kVoxels * 8);
  EXPECT_EQ(report["stages"][1]["bytes"], kVoxels * sizeof(float));
  EXPECT_EQ(report["settings"]["extent"], "full");
}

TEST_F(Provenance, StagesThatAreNotNeededAreNotRun) {
  // Without occlusion nothing is swept, and the report lists no sweep; normals from the distance bring it back.
  runWell({"render", kBallFile, "--occlusion", "none", "--size", "24x16", "--report", "report.json", "-o", "out.png"});
  const auto report = nlohmann::json::parse(fileBytes(path("report.json")));
  std::vector<std::string> names;
  for (const auto& stage : report["stages"]) names.push_back(stage["name"]);
  EXPECT_THAT(names, ::testing::ElementsAre("read", "upload", "frame", "write"));
  runWell({"render", kBallFile, "--occlusion", "none", "--normals", "distance", "--size", "24x16", "--report", "d.json",
           "-o", "out.png"});
  names.clear();
  const auto withDistance = nlohmann::json::parse(fileBytes(path("d.json")));
  for (const auto& stage : withDistance["stages"]) names.push_back(stage["name"]);
  EXPECT_THAT(names, ::testing::ElementsAre("read", "distance", "upload", "frame", "write"));
}

}  // namespace
}  // namespace isolume::test
