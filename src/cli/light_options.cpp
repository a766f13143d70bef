#include "src/cli/light_options.h"

#include <functional>
#include <glm/geometric.hpp>

#include "src/cli/option_builder.h"
#include "src/cli/parse_value.h"

namespace isolume {
namespace {

/// Beyond these a picture has nothing but one colour.
constexpr double kBrightest = 1e6, kMostExposure = 64;
/// With an albedo of .99 a path of that length still carries 4 % of its light.
constexpr int kMostReflections = 1024;
constexpr double kLargestSun = 90;

using Setter = std::function<void(LightRequest&, const std::string& option, const std::string& text)>;

Setter band(std::size_t index) {
  return [index](LightRequest& light, const std::string& option, const std::string& text) {
    light.bands[index] = parseColor(option, text).linear;
  };
}

/// The keys of a kind; those that every kind has come with them.
Choices<Setter> keysOf(LightKind kind) {
  Choices<Setter> keys{{"color", [](LightRequest& light, const std::string& option,
                                    const std::string& text) { light.color *= parseColor(option, text).linear; }},
                       {"intensity", [](LightRequest& light, const std::string& option, const std::string& text) {
                          light.color *= static_cast<float>(parseWithin(option, text, 0, kBrightest));
                        }}};
  if (kind == LightKind::gradient) {
    keys.emplace_back("zenith", band(0));
    keys.emplace_back("horizon", band(1));
    keys.emplace_back("ground", band(2));
  }
  if (kind == LightKind::sun) {
    keys.emplace_back("azimuth", [](LightRequest& light, const std::string& option, const std::string& text) {
      light.azimuthDegrees = parseNumber(option, text);
    });
    keys.emplace_back("elevation", [](LightRequest& light, const std::string& option, const std::string& text) {
      light.elevationDegrees = parseWithin(option, text, -90, 90);
    });
    keys.emplace_back("direction", [](LightRequest& light, const std::string& option, const std::string& text) {
      light.direction = parseVector(option, text);
      if (!(glm::length(*light.direction) > 0))
        throw UsageError(fmt::format("{}: expected a direction that is not 0, found {}", option, text));
    });
    keys.emplace_back("radius", [](LightRequest& light, const std::string& option, const std::string& text) {
      light.radiusDegrees = parsePositive(option, text);
      parseWithin(option, text, 0, kLargestSun);
    });
    keys.emplace_back("shadow", [](LightRequest& light, const std::string& option, const std::string& text) {
      light.shadow = parseChoice<SunShadow>(
          option, text, {{"soft", SunShadow::soft}, {"hard", SunShadow::hard}, {"turned", SunShadow::turned}});
    });
    keys.emplace_back("from", [](LightRequest& light, const std::string& option, const std::string& text) {
      light.fromCamera = parseChoice<bool>(option, text, {{"world", false}, {"camera", true}});
    });
  }
  if (kind == LightKind::octants) {
    keys.emplace_back("top", [](LightRequest& light, const std::string& option, const std::string& text) {
      if (!parseChoice<bool>(option, text, {{"only", true}, {"too", false}})) return;
      for (std::size_t s = 0; s < light.octants.size(); ++s)
        if (kOctants[s].towardsLight().z < 0) light.octants[s] = 0;
    });
    keys.emplace_back("intensities", [](LightRequest& light, const std::string& option, const std::string& text) {
      const std::vector<std::string> parts = splitList(text);
      if (parts.size() != light.octants.size())
        throw UsageError(fmt::format("{}: expected {} numbers, found {}", option, light.octants.size(), parts.size()));
      for (std::size_t s = 0; s < parts.size(); ++s)
        light.octants[s] = static_cast<float>(parseWithin(option, parts[s], 0, kBrightest));
    });
  }
  return keys;
}

}  // namespace

LightRequest parseLight(std::string_view option, std::string_view text) {
  const std::vector<std::string> parts = splitList(text, ":");
  LightRequest light;
  light.text = std::string(text);
  light.kind = parseChoice<LightKind>(option, parts.empty() ? "" : parts.front(),
                                      {{"sky", LightKind::sky},
                                       {"gradient", LightKind::gradient},
                                       {"sun", LightKind::sun},
                                       {"head", LightKind::head},
                                       {"octants", LightKind::octants}});
  const Choices<Setter> keys = keysOf(light.kind);
  std::vector<std::string> seen;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    const std::size_t equals = parts[i].find('=');
    const std::string key = parts[i].substr(0, equals), name = fmt::format("{} {}", option, parts.front());
    if (equals == std::string::npos)
      throw UsageError(fmt::format("{}: expected KEY=VALUE after each colon, found '{}'", name, parts[i]));
    const Setter set = parseChoice(name, key, keys);
    if (std::find(seen.begin(), seen.end(), key) != seen.end())
      throw UsageError(fmt::format("{}: expected each key once, found {} again", name, key));
    seen.push_back(key);
    set(light, fmt::format("{}:{}", name, key), parts[i].substr(equals + 1));
  }
  const auto given = [&seen](const char* key) { return std::find(seen.begin(), seen.end(), key) != seen.end(); };
  if (light.direction && (given("azimuth") || given("elevation") || given("from")))
    throw UsageError(fmt::format("{} sun: expected either a direction or angles, found both", option));
  if (light.radiusDegrees && light.shadow != SunShadow::soft)
    throw UsageError(fmt::format("{} sun: expected a radius with a soft shadow alone, found a {} one", option,
                                 light.shadow == SunShadow::hard ? "hard" : "turned"));
  return light;
}

void addLightOptions(CLI::App& app, LightingRequest& lighting) {
  OptionGroup group(app, "Light (default: a white sky)");
  // Repeated: each adds a light.
  app.add_option_function<std::vector<std::string>>(
         "--light",
         [&lighting](const std::vector<std::string>& texts) {
           lighting.lights.clear();  // of a preset
           for (const std::string& text : texts) lighting.lights.push_back(parseLight("--light", text));
         },
         "once or more: KIND[:KEY=VALUE...], each with color and\nintensity: sky; gradient (zenith, horizon, ground: "
         "colours);\nsun (azimuth, elevation as of the camera, or direction=X,Y,Z;\nshadow=soft with radius in "
         "degrees, "
         "hard or turned;\nfrom=camera: angles from the eye); head (from the eye, without\nshadows); octants "
         "(of the grid's axes: intensities=I0,...,I7, top=only)")
      ->type_name("LIGHT")
      ->allow_extra_args(false)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll)
      ->group("Light (default: a white sky)");
  group.value(
      "--environment", "FILE",
      [&lighting](const std::string&, const std::string& text) { lighting.environment = text; },
      "a map of the sky: equirectangular EXR or PNG; top +z,\ncentre +y, to the right +x");
  group.value(
      "--environment-rotation", "DEG",
      [&lighting](const std::string& option, const std::string& text) {
        lighting.rotationDegrees = parseNumber(option, text);
      },
      "turns it about +z, counter-clockwise from above (default: 0)");
  group.value(
      "--exposure", "EV",
      [&lighting](const std::string& option, const std::string& text) {
        lighting.exposure = parseWithin(option, text, -kMostExposure, kMostExposure);
      },
      "doublings of all light (default: 0)");
  group.value(
      "--bounces", "N|all",
      [&lighting](const std::string& option, const std::string& text) {
        lighting.bounces = text == "all" ? kAllBounces : parseCount(option, text, 0, kMostReflections);
      },
      "light that the surface sends on: N reflections, or as many\nas change anything (default: 0)");
  group.value(
      "--opacity", "A",
      [&lighting](const std::string& option, const std::string& text) {
        lighting.opacity = parseWithin(option, text, 0, 1);
      },
      "of a voxel of the solid, 0 to 1: below 1 light comes\nthrough (default: 1)");
}

}  // namespace isolume
