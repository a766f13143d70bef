// Options of `isolume render` beyond those of surface_options.h: camera, shading, picture.
#pragma once

#include <CLI/CLI.hpp>

#include "src/jobs/render_job.h"

namespace isolume {

void addRenderOptions(CLI::App& app, RenderJob& job);

/// UsageError for options that exclude each other or that the output's format has no place for.
void checkRenderOptions(const RenderJob& job);

}  // namespace isolume
