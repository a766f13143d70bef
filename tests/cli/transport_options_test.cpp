// --transport and --transmittance: what they come to, what they refuse, and what outputs say of them.
#include <gmock/gmock.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/picture.h"
#include "cli/program.h"
#include "src/cli/command_line.h"
#include "src/errors.h"
#include "src/io/vdb.h"

namespace isolume::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

template <class Job>
Job parse(const char* command, const char* output, std::vector<const char*> options) {
  std::vector<const char*> arguments{"isolume", command, "in.vdb", "-o", output};
  arguments.insert(arguments.end(), options.begin(), options.end());
  return std::get<Job>(parseCommandLine(static_cast<int>(arguments.size()), arguments.data()));
}
OcclusionSetting render(std::vector<const char*> options) {
  return chooseOcclusion(parse<RenderJob>("render", "out.exr", std::move(options)).occlusion);
}

TEST(TransportOptions, SchemesHaveTheirDefaults) {
  // Rays unless another scheme is asked for; step with the inner ramp, characteristic with the centred one, both with
  // the number of ordinates that was given and without a calibrated error.
  EXPECT_FALSE(render({}).transport);
  EXPECT_FALSE(render({"--transport", "rays"}).transport);
  EXPECT_EQ(render({"--transport", "rays"}).error, render({}).error);
  const OcclusionSetting step = render({"--transport", "step"});
  EXPECT_EQ(step.transport.value().scheme, TransportScheme::step);
  EXPECT_EQ(step.transport->transmittance, Transmittance::inside);
  EXPECT_EQ(step.transport->ordinates, TransportOptions().ordinates);
  EXPECT_EQ(step.ordinates.ordinates, TransportOptions().ordinates);
  EXPECT_FALSE(step.error);
  const OcclusionSetting other = render({"--transport", "characteristic", "--ordinates", "300"});
  EXPECT_EQ(other.transport.value().scheme, TransportScheme::characteristic);
  EXPECT_EQ(other.transport->transmittance, Transmittance::centred);
  EXPECT_EQ(other.transport->ordinates, 300);
}

TEST(TransportOptions, TransmittancesHaveTheirNames) {
  // Each name is a ramp, and the settings say both names again, in place of a refinement.
  for (const auto& [name, model] : {std::pair{"centred", Transmittance::centred},
                                    {"inner", Transmittance::inside},
                                    {"inner-power", Transmittance::insideByLength}})
    for (const char* scheme : {"step", "characteristic"}) {
      const OcclusionSetting setting = render({"--transport", scheme, "--transmittance", name});
      EXPECT_EQ(setting.transport.value().transmittance, model);
      const nlohmann::ordered_json settings = occlusionSettings(setting);
      EXPECT_EQ(settings["transport"], scheme);
      EXPECT_EQ(settings["transmittance"], name);
      EXPECT_FALSE(settings.contains("refinement"));
    }
  EXPECT_FALSE(occlusionSettings(render({})).contains("transport"));
}

TEST(TransportOptions, WhatOnlyRaysServeIsRefusedInOneLine) {
  // Lights, layers, levels and bounds on the error that are of rays, and a ramp without a scheme.
  const std::vector<std::pair<std::vector<const char*>, const char*>> refused{
      {{"--transport", "steps"}, "did you mean step?"},
      {{"--transport", "step", "--transmittance", "outer"}, "--transmittance: expected one of centred, inner"},
      {{"--transmittance", "inner"},
       "--transmittance: expected --transport step or characteristic beside it, found none"},
      {{"--transmittance", "inner", "--transport", "rays"}, "beside it, found rays"},
      {{"--transport", "step", "--occlusion", "octants"},
       "--transport: expected --occlusion ordinates beside it, or none, found octants"},
      {{"--transport", "rays", "--occlusion", "none"}, "--transport: expected --occlusion ordinates"},
      {{"--transport", "step", "--occlusion", "hbao"}, "--transport: expected with openness by sweeps, found"},
      {{"--transport", "step", "--quality", "good"}, "--quality: expected --transport rays beside it, found step"},
      {{"--transport", "characteristic", "--error", ".02"}, "--error: expected --transport rays beside it"},
      {{"--transport", "step", "--ordinates", "72", "--refinement", "2"},
       "--refinement: expected 1 beside --transport step, which sweeps voxels, found 2"},
      {{"--transport", "step", "--light", "sky"}, "--light: expected --transport rays beside it, found step"},
      {{"--transport", "step", "--environment", "map.exr"}, "--environment: expected --transport rays"},
      {{"--transport", "step", "--opacity", ".5"}, "--opacity: expected --transport rays"},
      {{"--transport", "step", "--bounces", "1"}, "--bounces: expected --transport rays"},
      {{"--transport", "step", "--preset", "clay"}, "--light: expected --transport rays"},
      {{"--transport", "step", "--preset", "translucent"}, "--preset translucent without --opacity: expected"},
      {{"--transport", "step", "--layers", "bent"}, "--layers bent: expected --transport rays"},
      {{"--transport", "step", "--layers", "thickness"}, "--layers thickness: expected --transport rays"},
      {{"--transport", "step", "--occlusion", "klehm11", "--bent-from", "sweep"},
       "--bent-from sweep: expected --transport rays beside it, found step"}};
  const auto expectRefused = [](const auto& body, const char* expected) {
    try {
      body();
      ADD_FAILURE() << "expected: " << expected;
    } catch (const UsageError& error) {
      EXPECT_THAT(error.what(), HasSubstr(expected));
      EXPECT_THAT(error.what(), Not(HasSubstr("\n")));
    }
  };
  for (const auto& [options, expected] : refused) expectRefused([&, &each = options] { render(each); }, expected);
  const std::vector<std::pair<std::vector<const char*>, const char*>> refusedByFields{
      {{"--transport", "step"}, "--transport: expected --with beside it"},
      {{"--ordinates", "72"}, "--ordinates: expected --with beside it"},
      {{"--with", "openness,bent", "--transport", "step"}, "--with bent: expected --transport rays beside it"},
      {{"--with", "thickness", "--transport", "step"}, "--with thickness: expected --transport rays beside it"},
      {{"--with", "openness", "--transmittance", "inner"}, "--transmittance: expected --transport step"}};
  for (const auto& [options, expected] : refusedByFields)
    expectRefused([&, &each = options] { parse<FieldsJob>("fields", "out.vdb", each); }, expected);
}

class Transported : public ProgramTest {
 protected:
  Transported() { runWell({"sample", "corner", "--size", "24", "--quiet", "-o", "corner.vdb"}); }
  std::vector<std::string> command(const std::string& name, const std::string& output,
                                   const std::vector<std::string>& options) const {
    std::vector<std::string> all{name, "corner.vdb", "--isovalue", "0.01", "--inside", "below", "-o", output};
    all.insert(all.end(), options.begin(), options.end());
    return all;
  }
};

TEST_F(Transported, PicturesAreThatOfRaysButForTheScheme) {
  // A picture by a scheme differs from that by rays, by .1 of openness at most on average; an exposure scales it; its
  // settings, in the file and in the report, draw it again.
  runWell(command("render", "rays.exr", {"--size", "40x40", "--ordinates", "128", "--layers", "ambient"}));
  for (const std::string scheme : {"step", "characteristic"}) {
    const std::vector<std::string> options{"--size", "40x40",    "--ordinates", "128",      "--transport",
                                           scheme,   "--layers", "ambient",     "--report", "report.json"};
    runWell(command("render", "out.exr", options));
    const Image rays = readImage(path("rays.exr")), image = readImage(path("out.exr"));
    const std::vector<float>&want = channel(rays, "ambient.Y"), &got = channel(image, "ambient.Y");
    double difference = 0;
    for (std::size_t i = 0; i < want.size(); ++i) difference += std::abs(double{got[i]} - double{want[i]});
    difference /= static_cast<double>(want.size());
    EXPECT_GT(difference, 0.001) << scheme;
    EXPECT_LT(difference, 0.1) << scheme;
    EXPECT_THAT(metadata(image, "isolume:settings"),
                HasSubstr("--occlusion ordinates --ordinates 128 --transport " + scheme + " --transmittance "));
    const auto report = nlohmann::json::parse(fileBytes(path("report.json")));
    EXPECT_EQ(report["settings"]["transport"], scheme);
    EXPECT_FALSE(report["settings"].contains("calibrated_error"));
  }
  for (const std::string exposure : {"0", "1"})
    runWell(
        command("render", "lit" + exposure + ".exr",
                {"--size", "40x40", "--transport", "step", "--exposure", exposure, "--layers", "irradiance,depth"}));
  const Image once = readImage(path("lit0.exr")), twice = readImage(path("lit1.exr"));
  const std::vector<float>& depth = channel(once, "Z");
  for (std::size_t i = 0; i < depth.size(); ++i)
    if (std::isfinite(depth[i])) {
      EXPECT_EQ(channel(twice, "irradiance.R")[i], 2 * channel(once, "irradiance.R")[i]) << i;
    }
}

TEST_F(Transported, FieldsHoldTheOpennessOfThePicture) {
  // The grid of `fields` is that of the scheme, within [0, 1], and the report states it.
  runWell(command("fields", "rays.vdb", {"--with", "openness", "--ordinates", "128"}));
  runWell(command("fields", "step.vdb",
                  {"--with", "openness", "--ordinates", "128", "--transport", "step", "--transmittance", "inner-power",
                   "--report", "report.json"}));
  const Volume rays = readVdb(path("rays.vdb"), "openness"), step = readVdb(path("step.vdb"), "openness");
  double difference = 0, known = 0;
  for (std::size_t i = 0; i < rays.values.count(); ++i) {
    const float want = rays.values.data()[i], got = step.values.data()[i];
    ASSERT_TRUE(got >= 0 && got <= 1) << i;
    if (want == 0) continue;
    difference += std::abs(double{got} - double{want});
    ++known;
  }
  EXPECT_GT(difference / known, 0.001);
  EXPECT_LT(difference / known, 0.1);
  const auto report = nlohmann::json::parse(fileBytes(path("report.json")));
  EXPECT_EQ(report["settings"]["transport"], "step");
  EXPECT_EQ(report["settings"]["transmittance"], "inner-power");
  EXPECT_EQ(report["settings"]["ordinates"], 128);
}

}  // namespace
}  // namespace isolume::test
