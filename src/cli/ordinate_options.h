// Options of ordinates that several commands share.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "src/jobs/occlusion_method.h"

namespace isolume {

/// --ordinates; `meaning` starts its description.
void addOrdinatesOption(CLI::App& app, const std::string& group, OcclusionRequest& request, const std::string& meaning);

/// --transport and --transmittance.
void addTransportOptions(CLI::App& app, const std::string& group, OcclusionRequest& request);

}  // namespace isolume
