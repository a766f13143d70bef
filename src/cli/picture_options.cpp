#include "src/cli/picture_options.h"

#include "src/cli/option_builder.h"
#include "src/cli/parse_value.h"

namespace isolume {

void addCameraOptions(CLI::App& app, CameraRequest& camera) {
  OptionGroup group(app, "Camera (default: frames the whole solid)");
  const Framing defaults;
  const auto number = [&group](const std::string& flag, const std::string& unit, std::optional<double>& target,
                               const std::string& description) {
    group.value(
        flag, unit,
        [&target](const std::string& option, const std::string& text) { target = parseNumber(option, text); },
        description);
  };
  const auto vector = [&group](const std::string& flag, std::optional<glm::dvec3>& target,
                               const std::string& description) {
    group.value(
        flag, "X,Y,Z",
        [&target](const std::string& option, const std::string& text) { target = parseVector(option, text); },
        description);
  };
  number("--azimuth", "DEG", camera.azimuth,
         fmt::format("around the up axis; 0 looks along +y, 90 along -x (default: {})", defaults.azimuthDegrees));
  number("--elevation", "DEG", camera.elevation,
         fmt::format("above the horizon (default: {})", defaults.elevationDegrees));
  vector("--eye", camera.eye, "where the camera is, world units; instead of the two above");
  vector("--target", camera.target, "what it looks at, world units; with --eye");
  vector("--up", camera.up, "what points upwards in the picture (default: 0,0,1)");
  number("--roll", "DEG", camera.roll, "turns the camera clockwise (default: 0)");
  group.value(
      "--zoom", "FACTOR",
      [&camera](const std::string& option, const std::string& text) { camera.zoom = parsePositive(option, text); },
      "magnifies about the centre (default: 1)");
  group.value(
      "--projection", "KIND",
      [&camera](const std::string& option, const std::string& text) {
        camera.projection = parseChoice<Projection>(
            option, text, {{"perspective", Projection::perspective}, {"orthographic", Projection::orthographic}});
      },
      "perspective or orthographic (default: perspective)");
  group.value(
      "--fov", "DEG",
      [&camera](const std::string& option, const std::string& text) {
        camera.fov = parseBetween(option, text, 0, 180);
      },
      fmt::format("vertical field of view, perspective (default: {})", defaults.fovDegrees));
  group.value(
      "--height", "LENGTH",
      [&camera](const std::string& option, const std::string& text) { camera.height = parsePositive(option, text); },
      "height of the picture, world units; orthographic with --eye");
}

void addSizeOption(CLI::App& app, glm::ivec2& size) {
  OptionGroup(app, "Output")
      .value(
          "--size", "WxH",
          [&size](const std::string& option, const std::string& text) { size = parseSize(option, text); },
          fmt::format("pixels (default: {}x{})", size.x, size.y));
}

void addAlbedoOption(CLI::App& app, Color& albedo) {
  OptionGroup(app, "Shading")
      .value(
          "--albedo", "COLOR",
          [&albedo](const std::string& option, const std::string& text) { albedo = parseColor(option, text); },
          "surface colour: name, #rrggbb or r,g,b in 0..1 (default: " + albedo.text + ")");
}

void addBackgroundOption(CLI::App& app, Color& background, bool& transparent) {
  OptionGroup(app, "Shading")
      .value(
          "--background", "COLOR",
          [&background, &transparent](const std::string& option, const std::string& text) {
            transparent = text == "transparent";
            background = transparent ? Color{"transparent", glm::vec3(0)} : parseColor(option, text);
          },
          "the same, or transparent (default: " + background.text + ")");
}

}  // namespace isolume
