// Options that several commands share: the input and its surface, and how the program runs.
#pragma once

#include <CLI/CLI.hpp>

#include "src/jobs/run_options.h"
#include "src/jobs/surface.h"

namespace isolume {

void addReadOptions(CLI::App& app, std::string& input, ReadOptions& target);
void addSurfaceOptions(CLI::App& app, SurfaceRequest& target);
/// How the distance is found, for commands that sweep; `band`: how much of it a band is.
void addDistanceOptions(CLI::App& app, DistanceRequest& target, const std::string& defaultExtent,
                        const std::string& band);
void addOutputOption(CLI::App& app, std::string& target, const std::string& valueName, const std::string& description);
void addRunOptions(CLI::App& app, RunOptions& target);

}  // namespace isolume
