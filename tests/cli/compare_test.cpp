// `isolume compare` on files, its exit codes and its heat map.
#include <gmock/gmock.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "cli/picture.h"
#include "cli/program.h"

namespace isolume::test {
namespace {

using ::testing::HasSubstr;

constexpr int kLimitBroken = 6, kUsage = 2, kInput = 3, kOutput = 5;
constexpr glm::ivec2 kSize{16, 8};

/// Everything but the first column is hit; openness `ambient` there.
void writePicture(const std::string& path, float ambient, float firstHit = 0.5f, glm::ivec2 size = kSize) {
  Image image;
  image.size = size;
  const auto count = static_cast<std::size_t>(size.x * size.y);
  image.channels = {{"ambient.Y", std::vector<float>(count, ambient)}, {"Z", std::vector<float>(count, 2)}};
  for (std::size_t row = 0; row < static_cast<std::size_t>(size.y); ++row)
    image.channels[1].values[row * static_cast<std::size_t>(size.x)] = std::numeric_limits<float>::infinity();
  image.channels[0].values[1] = firstHit;
  writeImage(path, image);
}

class Compare : public ProgramTest {
 protected:
  Compare() {
    writePicture(path("want.exr"), 0.5f);
    writePicture(path("got.exr"), 0.75f);
  }
};

bool isOneLine(const std::string& text) { return !text.empty() && text.find('\n') == text.size() - 1; }

TEST_F(Compare, PrintsMeasuresForPeopleAndAsJson) {
  // 120 pixels hit by both, one of them equal and the rest 1/4 too bright: the numbers of that, in both forms.
  const std::string text = runWell({"compare", "got.exr", "want.exr"}).out;
  for (const char* part : {"ambient of got.exr against want.exr", "120 of 128", "RMSE", "bias", "SSIM", "0.24792"})
    EXPECT_THAT(text, HasSubstr(part));
  const Outcome outcome = runWell({"compare", "got.exr", "want.exr", "--json"});
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(outcome.err, "");
  EXPECT_EQ(json["pixels"]["compared"], 120);
  EXPECT_EQ(json["miss"], 0);
  EXPECT_EQ(json["measures"][0]["name"], "ambient.Y");
  EXPECT_EQ(json["measures"][0]["bias"], 119 * 0.25 / 120);
  EXPECT_EQ(json["measures"][0]["p95"], 0.25);
  EXPECT_EQ(json["measures"][0]["max_pixel"], nlohmann::json({2, 0}));
  EXPECT_TRUE(json["measures"][0]["reference_noise"].is_null());
}

TEST_F(Compare, LimitsDecideTheExitCode) {
  // Limits that are kept: 0. Any that is broken: 6, the measures on standard output all the same, one line of error.
  runWell({"compare", "got.exr", "want.exr", "--max-rmse", "0.25", "--max-bias", "0.25", "--max-mean", "0.25",
           "--max-p95", "0.25", "--max-error", "0.25", "--min-ssim", "0.5", "--max-miss", "0"});
  for (const auto& [option, limit] : {std::pair{"--max-rmse", "0.2"},
                                      {"--max-bias", "0.2"},
                                      {"--max-mean", "0.2"},
                                      {"--max-p95", "0.2"},
                                      {"--max-error", "0.2"},
                                      {"--min-ssim", "0.999"}}) {
    const Outcome outcome = run({"compare", "got.exr", "want.exr", option, limit});
    EXPECT_EQ(outcome.exitCode, kLimitBroken) << option;
    EXPECT_TRUE(isOneLine(outcome.err)) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(std::string("expected at ") + (option[3] == 'a' ? "most " : "least ") + limit));
    EXPECT_THAT(outcome.out, HasSubstr("RMSE"));
  }
}

TEST_F(Compare, MissesAndNanFail) {
  // A pixel hit by one only breaks --max-miss alone; a NaN on a hit fails without any limit.
  Image image = readImage(path("got.exr"));
  for (ImageChannel& channel : image.channels)
    if (channel.name == "Z") channel.values[5] = std::numeric_limits<float>::infinity();
  writeImage(path("hole.exr"), image);
  runWell({"compare", "hole.exr", "want.exr"});
  EXPECT_EQ(run({"compare", "hole.exr", "want.exr", "--max-miss", "0.001"}).exitCode, kLimitBroken);
  writePicture(path("nan.exr"), 0.5f, std::numeric_limits<float>::quiet_NaN());
  for (const auto& [got, want] : {std::pair{"nan.exr", "want.exr"}, {"want.exr", "nan.exr"}}) {
    const Outcome outcome = run({"compare", got, want});
    EXPECT_EQ(outcome.exitCode, kLimitBroken);
    EXPECT_THAT(outcome.err, HasSubstr("found 1 NaN and 0 infinite, the first in nan.exr at pixel (1, 0)"));
  }
}

TEST_F(Compare, HeatMapIsWrittenAlsoWhenALimitIsBroken) {
  // The PNG has the picture's width or more and a bar below, says its command, and is there after exit code 6 too.
  const Outcome outcome =
      run({"compare", "got.exr", "want.exr", "--max-rmse", "0.1", "--heat", "heat.png", "--heat-range", "0.25"});
  EXPECT_EQ(outcome.exitCode, kLimitBroken);
  const Image heat = readImage(path("heat.png"));
  EXPECT_GE(heat.size.x, kSize.x);
  EXPECT_GT(heat.size.y, kSize.y);
  EXPECT_THAT(metadata(heat, "isolume:command"), HasSubstr("compare got.exr want.exr"));
  const auto pixel = [&](const char* name) { return channel(heat, name)[static_cast<std::size_t>(3)]; };
  EXPECT_GT(pixel("R"), pixel("G"));  // 1/4 too bright: the orange end
  EXPECT_GT(pixel("G"), pixel("B"));
  const std::string once = fileBytes(path("heat.png"));
  run({"compare", "got.exr", "want.exr", "--max-rmse", "0.1", "--heat", "heat.png", "--heat-range", "0.25"});
  EXPECT_EQ(fileBytes(path("heat.png")), once);
}

TEST_F(Compare, FilesThatCannotBeCompared) {
  // Size, layer, format: exit code 3 and one line; nothing on standard output, no heat map.
  writePicture(path("small.exr"), 0.5f, 0.5f, {8, 8});
  writeBytes(path("text.exr"), "no picture");
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"compare", "small.exr", "want.exr"},
                                                    {"compare", "got.exr", "want.exr", "--layer", "normal"},
                                                    {"compare", "text.exr", "want.exr"},
                                                    {"compare", "got.exr", "absent.exr"}}) {
    std::vector<std::string> withHeat = arguments;
    withHeat.insert(withHeat.end(), {"--heat", "heat.png"});
    const Outcome outcome = run(withHeat);
    EXPECT_EQ(outcome.exitCode, kInput) << outcome.err;
    EXPECT_TRUE(isOneLine(outcome.err)) << outcome.err;
    EXPECT_EQ(outcome.out, "");
  }
  EXPECT_THAT(files(), ::testing::Not(::testing::Contains("heat.png")));
}

TEST_F(Compare, WrongOptionsAreRefused) {
  // Exit code 2 and one line that names the option; the pictures stay as they are.
  const std::string before = fileBytes(path("want.exr"));
  writeBytes(path("picture.png"), before);  // an EXR is known by its content
  const std::pair<std::vector<std::string>, const char*> cases[] = {
      {{}, "two pictures"},
      {{"got.exr"}, "two pictures"},
      {{"got.exr", "want.exr", "more.exr"}, "more.exr"},
      {{"got.exr", "want.exr", "--max-rmse", "-1"}, "--max-rmse"},
      {{"got.exr", "want.exr", "--max-miss", "2"}, "--max-miss"},
      {{"got.exr", "want.exr", "--min-ssim", "nan"}, "--min-ssim"},
      {{"got.exr", "want.exr", "--max-rsme", "1"}, "did you mean --max-rmse"},
      {{"got.exr", "want.exr", "--heat", "want.exr"}, "--heat"},
      {{"got.exr", "picture.png", "--heat", "./picture.png"}, "other than the pictures"},
      {{"got.exr", "want.exr", "--heat-range", "1"}, "--heat-range"},
      {{"got.exr", "want.exr", "--heat", "heat.png", "--heat-range", "0"}, "--heat-range"}};
  for (const auto& [arguments, part] : cases) {
    std::vector<std::string> all{"compare"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const Outcome outcome = run(all);
    EXPECT_EQ(outcome.exitCode, kUsage) << part << ": " << outcome.err;
    EXPECT_TRUE(isOneLine(outcome.err)) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(part));
  }
  for (const char* file : {"want.exr", "picture.png"}) EXPECT_EQ(fileBytes(path(file)), before);
}

TEST_F(Compare, HeatMapThatCannotBeWritten) {
  // A folder that does not exist: exit code 5 before anything is compared.
  const Outcome outcome = run({"compare", "got.exr", "want.exr", "--heat", "absent/heat.png"});
  EXPECT_EQ(outcome.exitCode, kOutput);
  EXPECT_EQ(outcome.out, "");
}

TEST_F(Compare, RenderedPicturesCompareByDepth) {
  // A ball drawn twice is identical in every layer; read at the hit, its openness is darker everywhere on average.
  writeBall(path("ball_17x17x17_float32.raw"), 17, 6);
  for (const auto& [offset, output] : {std::pair{"2", "a.exr"}, {"2", "b.exr"}, {"0", "c.exr"}})
    runWell({"render", "ball_17x17x17_float32.raw", "--isovalue", "0", "--size", "24x24", "--layers", "all",
             "--occlusion", "octants", "--occlusion-offset", offset, "-o", output});
  for (const char* layer : {"ambient", "normal", "position", "Z"})
    runWell({"compare", "a.exr", "b.exr", "--layer", layer, "--max-error", "0", "--min-ssim", "1", "--max-miss", "0"});
  const auto json = nlohmann::json::parse(runWell({"compare", "c.exr", "a.exr", "--json"}).out);
  EXPECT_LT(json["measures"][0]["bias"].get<double>(), 0);
  EXPECT_EQ(json["miss"], 0);
  EXPECT_EQ(json["hits_from"]["got"], "Z");
}

}  // namespace
}  // namespace isolume::test
