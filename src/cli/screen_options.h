// Options of `isolume render` for openness from the screen, and the list of all names that --occlusion takes.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "src/jobs/occlusion_method.h"
#include "src/jobs/screen_request.h"

namespace isolume {

/// The value of --occlusion: either of the two is set and the other reset.
void parseOcclusion(const std::string& option, const std::string& text, OcclusionRequest& occlusion,
                    ScreenRequest& screen);

void addScreenOptions(CLI::App& app, ScreenRequest& screen);

}  // namespace isolume
