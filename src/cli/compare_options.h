// Options of `isolume compare`.
#pragma once

#include <CLI/CLI.hpp>

#include "src/jobs/compare_job.h"

namespace isolume {

void addCompareOptions(CLI::App& app, CompareJob& job);

/// UsageError for a missing picture, a heat map that is no PNG or would replace a picture, and a range without one.
void checkCompareOptions(const CompareJob& job);

}  // namespace isolume
