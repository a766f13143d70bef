#include "src/cli/render_options.h"

#include <filesystem>

#include "raymarch/context.h"
#include "src/cli/light_options.h"
#include "src/cli/option_builder.h"
#include "src/cli/ordinate_options.h"
#include "src/cli/parse_value.h"
#include "src/cli/picture_options.h"
#include "src/cli/presets.h"
#include "src/cli/screen_options.h"
#include "src/cli/surface_options.h"

namespace isolume {
namespace {

constexpr double kMaxOffset = 16;  ///< voxels; farther away the light is no longer that of the surface point
constexpr int kMaxSamples = 1024;  ///< per pixel; beyond it nothing visible changes

void addShadingOptions(CLI::App& app, RenderJob& job) {
  OptionGroup group(app, "Shading");
  OcclusionRequest& occlusion = job.occlusion;
  group.value(
      "--occlusion", "METHOD",
      [&job](const std::string& option, const std::string& text) {
        parseOcclusion(option, text, job.occlusion, job.screen);
      },
      "ordinates: ambient occlusion by many directions;\nsingh10: by eight octant sweeps, as published;\n"
      "octants: the same, read above the surface;\n"
      "combined: the octants as one number;\nnone: a head light, nothing swept;\n"
      "from the screen: crytek, hbao, gtao, bitmask, ssdo,\ngpu-sphere, gpu-hemisphere, gpu-importance, gpu-tangent,\n"
      "gpu-disk, szirmay10-containment, szirmay10-volumetric,\nloos10-point, -line, -area, klehm11,\nenv-importance "
      "(default: ordinates)");
  group.value(
      "--quality", "LEVEL",
      [&occlusion](const std::string& option, const std::string& text) {
        occlusion.quality = parseChoice<OcclusionQuality>(
            option, text,
            {{"draft", OcclusionQuality::draft}, {"good", OcclusionQuality::good}, {"best", OcclusionQuality::best}});
      },
      "draft, good or best: how exact the openness is\n(default: good)");
  group.value(
      "--error", "RMSE",
      [&occlusion](const std::string& option, const std::string& text) {
        occlusion.error = parsePositive(option, text);
      },
      "instead of --quality: the cheapest setting whose\nerror on the reference scenes was at most that");
  addOrdinatesOption(app, "Shading", occlusion, "instead of --quality: directions");
  group.value(
      "--refinement", "N",
      [&occlusion](const std::string& option, const std::string& text) {
        occlusion.refinement = parseCount(option, text, 1, kMostRefinement);
      },
      fmt::format("lattice points per voxel for --ordinates, 1 or {}\n(default: {})", kMostRefinement,
                  OrdinateOptions().refinement));
  addTransportOptions(app, "Shading", occlusion);
  group.value(
      "--occlusion-offset", "VOXELS",
      [&occlusion](const std::string& option, const std::string& text) {
        occlusion.offset = parseWithin(option, text, 0, kMaxOffset);
      },
      "where octants are read: so far above the surface along\nthe normal (default: singh10 0, octants 2)");
  group.value(
      "--octant-terms", "TERMS",
      [&occlusion](const std::string& option, const std::string& text) {
        occlusion.openPlane = parseChoice<bool>(option, text, {{"published", false}, {"open-plane", true}});
      },
      "published: as in the paper; open-plane: divided by what\neight octants give on an open plane, which is then 1\n"
      "(default: published)");
  group.value(
      "--normals", "SOURCE",
      [&job](const std::string& option, const std::string& text) {
        job.normals = parseChoice<NormalSource>(option, text,
                                                {{"data", NormalSource::data}, {"distance", NormalSource::distance}});
      },
      "gradient of the data or of the distance (default: data)");
  group.value(
      "--gamma", "G",
      [&job](const std::string& option, const std::string& text) { job.gamma = parsePositive(option, text); },
      "brightens occluded parts: openness^(1/G) (default: 1)");
  addAlbedoOption(app, job.albedo);
  addBackgroundOption(app, job.background, job.transparent);
}

void addColorOptions(CLI::App& app, RenderJob& job) {
  OptionGroup group(app, "Colour");
  ColorRequest& color = job.color;
  group.value(
      "--color-by", "FILE|x|y|z", [&color](const std::string&, const std::string& text) { color.by = text; },
      "a volume of the same world, of any grid, whose values\ncolour the surface in place of --albedo; or a "
      "coordinate");
  group.value(
      "--color-grid", "NAME", [&color](const std::string&, const std::string& text) { color.grid = text; },
      "grid of a VDB file to colour by (default: its only one)");
  group.value(
      "--color-range", "LOW,HIGH",
      [&color](const std::string& option, const std::string& text) {
        const std::vector<std::string> ends = splitList(text);
        if (ends.size() != 2)
          throw UsageError(fmt::format("{}: expected two numbers, LOW,HIGH, found '{}'", option, text));
        color.range = glm::dvec2(parseNumber(option, ends[0]), parseNumber(option, ends[1]));
        if (!(color.range->x < color.range->y))
          throw UsageError(fmt::format("{}: expected LOW below HIGH, found {}", option, text));
      },
      "what the ends of the map stand for; beyond them nothing\nchanges (default: the field's smallest and largest)");
  Choices<ColorMap> maps;
  for (const ColorMap map : {ColorMap::sequential, ColorMap::diverging, ColorMap::grey})
    maps.emplace_back(colorMapName(map), map);
  group.value(
      "--color-map", "NAME",
      [&color, maps](const std::string& option, const std::string& text) {
        color.map = parseChoice(option, text, maps);
      },
      "sequential, diverging (blue, white, orange) or grey;\nunknown values are grey (default: sequential)");
}

Layers parseLayers(const std::string& option, const std::string& text) {
  Layers layers;
  const Choices<bool Layers::*> choices{{"ambient", &Layers::ambient},     {"irradiance", &Layers::irradiance},
                                        {"normal", &Layers::normal},       {"position", &Layers::position},
                                        {"depth", &Layers::depth},         {"bent", &Layers::bent},
                                        {"thickness", &Layers::thickness}, {"all", &Layers::all}};
  for (const std::string& name : splitList(text)) layers.*parseChoice(option, name, choices) = true;
  return layers;
}

void addPictureOptions(CLI::App& app, RenderJob& job) {
  addOutputOption(app, job.output, "FILE", "picture to write: .png (sRGB) or .exr (linear float)");
  addSizeOption(app, job.size);
  OptionGroup group(app, "Output");
  group.value(
      "--samples", "N",
      [&job](const std::string& option, const std::string& text) {
        job.samples = parseCount(option, text, 1, kMaxSamples);
      },
      fmt::format("anti-aliasing samples per pixel (default: {})", job.samples));
  group.value(
      "--bit-depth", "BITS",
      [&job](const std::string& option, const std::string& text) {
        job.bitDepth = parseChoice<int>(option, text, {{"8", 8}, {"16", 16}});
      },
      "8 or 16, PNG (default: 8)");
  group.value(
      "--layers", "LIST",
      [&job](const std::string& option, const std::string& text) { job.layers = parseLayers(option, text); },
      "EXR: ambient, irradiance, normal, position, depth, bent,\nthickness or all; all adds bent and thickness only "
      "if\nthey are named too (default: none)");
}

}  // namespace

void addRenderOptions(CLI::App& app, RenderJob& job) {
  addPictureOptions(app, job);
  // Before all options that may replace a part of it: they are read in this order.
  OptionGroup(app, "Shading")
      .value(
          "--preset", "NAME",
          [&job](const std::string& option, const std::string& text) { applyPreset(option, text, job); },
          "a ready-made look: singh10, clay, studio, cloudy or\ntranslucent; other options replace their part of it");
  addCameraOptions(app, job.camera);
  addShadingOptions(app, job);
  addColorOptions(app, job);
  addLightOptions(app, job.light);
  addScreenOptions(app, job.screen);
  Choices<std::string> backends{{"auto", "auto"}};
  std::string list = "auto";
  for (const std::string_view name : backendNames()) {
    backends.emplace_back(name, name);
    list += ", " + std::string(name);
  }
  OptionGroup(app, "Running")
      .value(
          "--backend", "NAME",
          [&job, backends](const std::string& option, const std::string& text) {
            job.backend = parseChoice(option, text, backends);
          },
          fmt::format("OpenGL context: {} (default: auto)", list));
}

void checkRenderOptions(const RenderJob& job) {
  checkCamera(job.camera);
  const std::string ending = std::filesystem::path(job.output).extension().string();
  if (ending != ".png" && ending != ".exr")
    throw UsageError(fmt::format("--output: expected a name that ends in .png or .exr, found '{}'", job.output));
  if (ending == ".png" && job.layers.any())
    throw UsageError(fmt::format("--layers: expected an .exr to hold them, found '{}'", job.output));
  if (ending == ".exr" && job.bitDepth)
    throw UsageError(fmt::format("--bit-depth: expected a .png (an .exr holds 32-bit floats), found '{}'", job.output));
  checkColorRequest(job.color);
  if (!job.color.by.empty() && job.light.bounces.value_or(0) != 0)
    throw UsageError("--bounces: expected a surface of one albedo, found --color-by");
  const OcclusionSetting occlusion = chooseOcclusion(job.occlusion);
  const OcclusionMethod method = occlusion.method;
  checkScreenRequest(job.screen, givenOption(job.occlusion));
  checkScreenLight(job.screen, job.light);
  const bool openness = job.screen.estimator && !readsSky(*job.screen.estimator);
  if (job.screen.estimator && (job.layers.bent || job.layers.thickness || (job.layers.irradiance && openness)))
    throw UsageError(fmt::format("--layers: expected {}, normal, position or depth with --occlusion {}, found others",
                                 openness ? "ambient" : "ambient, irradiance",
                                 screenEstimatorName(*job.screen.estimator)));
  checkLighting(job.light, method);
  if (const char* option = beyondEvenSky(job.light)) needRays(occlusion, option);
  if (sweepsBent(job.screen)) needRays(occlusion, "--bent-from sweep");
  if (job.layers.bent || job.layers.thickness)
    needRays(occlusion, job.layers.bent ? "--layers bent" : "--layers thickness");
  if (isTranslucent(job.light) && job.occlusion.refinement.value_or(1) != 1)
    throw UsageError(
        fmt::format("--refinement: expected 1 beside a translucent solid, found {}", *job.occlusion.refinement));
  if ((job.layers.bent || job.layers.thickness) && method != OcclusionMethod::ordinates)
    throw UsageError(fmt::format("--layers: expected --occlusion ordinates beside '{}', found {}",
                                 job.layers.bent ? "bent" : "thickness", occlusionName(method)));
  if (job.layers.ambient && !isPlain(job.light))
    throw UsageError(
        fmt::format("--layers: expected 'irradiance' in place of 'ambient' beside {}: light is more than "
                    "openness",
                    givenOption(job.light)));
  if (job.occlusion.method == OcclusionMethod::none && job.layers.ambient)
    throw UsageError("--layers: expected no 'ambient' with --occlusion none, which computes no openness");
}

}  // namespace isolume
