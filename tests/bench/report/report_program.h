// What the report's programs have in common: options by CLI11, one JSON object on standard output, one line on error.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <nlohmann/json.hpp>

namespace isolume::bench {

/// Parses, works, prints. Exit codes as of the program itself: 2 usage, 3 input, 4 GPU, 5 output, 1 anything else.
int runReportProgram(CLI::App& app, int argc, char** argv, const std::function<nlohmann::ordered_json()>& work);

}  // namespace isolume::bench
