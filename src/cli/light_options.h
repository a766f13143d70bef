// Options of `isolume render` about light: --light, --environment, --bounces and what belongs to them.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <string_view>

#include "src/jobs/light_request.h"

namespace isolume {

void addLightOptions(CLI::App& app, LightingRequest& lighting);

/// KIND[:KEY=VALUE...], as the help of --light says. UsageError.
LightRequest parseLight(std::string_view option, std::string_view text);

}  // namespace isolume
