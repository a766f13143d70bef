#include <gmock/gmock.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "cli/picture.h"
#include "cli/program.h"

namespace isolume::test {
namespace {

using ::testing::HasSubstr;

nlohmann::json parse(const std::string& text) { return nlohmann::json::parse(text); }

TEST_F(ProgramTest, InfoTellsLayoutRangeAndHistogram) {
  // Dimensions, type, spacing, origin, extent, range, mean, NaN count, histogram and isovalue are printed.
  std::string bytes = ballBytes(9, 3);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  bytes.replace(0, sizeof nan, reinterpret_cast<const char*>(&nan), sizeof nan);
  writeBytes(path("ball_9x9x9_float32.raw"), bytes);
  const std::vector<std::string> command{"info",    "ball_9x9x9_float32.raw", "--spacing", "1,2,0.5", "--origin",
                                         "10,20,30"};
  const std::string text = runWell(command).out;
  for (const char* part : {"raw, float32", "9 x 9 x 9 (729 voxels)", "spacing     1 2 0.5", "origin      10 20 30",
                           "8 x 16 x 4, from (10, 20, 30) to (18, 36, 34)", "1 NaN, 0 infinite", "to 3, mean",
                           "histogram", "isovalue", "inside above"})
    EXPECT_THAT(text, HasSubstr(part));
  std::vector<std::string> asJson = command;
  asJson.push_back("--json");
  const nlohmann::json info = parse(runWell(asJson).out);
  EXPECT_EQ(info["dims"], nlohmann::json({9, 9, 9}));
  EXPECT_EQ(info["voxels"], 729);
  EXPECT_EQ(info["spacing"], nlohmann::json({1.0, 2.0, 0.5}));
  EXPECT_EQ(info["values"]["nan"], 1);
  EXPECT_EQ(info["values"]["max"], 3.0);
  std::size_t counted = 0;
  for (const auto& bin : info["values"]["histogram"]) counted += bin.get<std::size_t>();
  EXPECT_EQ(counted, 728u);
}

TEST_F(ProgramTest, RenderTakesTheIsovalueThatInfoPrints) {
  // The default isovalue of render is that of info, with the same reason.
  writeBall(path("ball_17x17x17_float32.raw"), 17, 6);
  const nlohmann::json info = parse(runWell({"info", "ball_17x17x17_float32.raw", "--json"}).out);
  runWell({"render", "ball_17x17x17_float32.raw", "--size", "8x8", "--report", "r.json", "-o", "out.png"});
  const nlohmann::json report = parse(fileBytes(path("r.json")));
  EXPECT_EQ(report["settings"]["isovalue"], info["isovalue"]);
  EXPECT_EQ(report["settings"]["isovalue_choice"], info["isovalue_choice"]);
}

TEST_F(ProgramTest, InfoListsTheGridsOfAVdb) {
  // A level set is told by name, type, kind and transform, and its default isovalue is 0 with the inside below.
  runWell({"sample", "spheres", "--size", "32", "--quiet", "-o", "spheres.vdb"});
  const std::string text = runWell({"info", "spheres.vdb"}).out;
  for (const char* part : {"VDB", "spheres: float, level set", "active voxels", "0 by default", "inside below"})
    EXPECT_THAT(text, HasSubstr(part));
}

TEST_F(ProgramTest, SpecialValuesAreToldOnceAndNotWhenQuiet) {
  // Rendering a volume with NaN and infinities warns in one line with their number; --quiet says nothing.
  std::string bytes = ballBytes(9, 3);
  const float special[] = {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
                           -std::numeric_limits<float>::infinity()};
  bytes.replace(0, sizeof special, reinterpret_cast<const char*>(special), sizeof special);
  writeBytes(path("ball_9x9x9_float32.raw"), bytes);
  const std::vector<std::string> command{"render", "ball_9x9x9_float32.raw", "--isovalue", "0", "--size", "8x8", "-o",
                                         "out.png"};
  const std::string told = runWell(command).err;
  const std::string warning =
      "isolume: warning: ball_9x9x9_float32.raw: 3 of 729 values are NaN or infinite and count as outside\n";
  EXPECT_THAT(told, HasSubstr(warning));
  EXPECT_EQ(told.find("warning"), told.rfind("warning"));
  std::vector<std::string> quiet = command;
  quiet.push_back("--quiet");
  EXPECT_EQ(runWell(quiet).err, "");
}

}  // namespace
}  // namespace isolume::test
