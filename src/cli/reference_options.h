// Options of `isolume reference` beyond those of surface_options.h. What makes no sense together: checkReference().
#pragma once

#include <CLI/CLI.hpp>

#include "src/jobs/reference_job.h"

namespace isolume {

void addReferenceOptions(CLI::App& app, ReferenceJob& job);

}  // namespace isolume
