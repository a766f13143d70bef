// Options that the commands which make pictures share: camera, size, colours.
#pragma once

#include <CLI/CLI.hpp>
#include <glm/vec2.hpp>

#include "src/jobs/camera_choice.h"
#include "src/jobs/color.h"

namespace isolume {

void addCameraOptions(CLI::App& app, CameraRequest& camera);
void addSizeOption(CLI::App& app, glm::ivec2& size);
void addAlbedoOption(CLI::App& app, Color& albedo);
void addBackgroundOption(CLI::App& app, Color& background, bool& transparent);

}  // namespace isolume
