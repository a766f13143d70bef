// Ready-made looks: lights, albedo and what belongs to them, under one name.
#pragma once

#include <string_view>

#include "src/jobs/render_job.h"

namespace isolume {

/// singh10, clay, studio, cloudy or translucent: sets what the look needs; options beside it replace their part of it.
/// UsageError for another name.
void applyPreset(std::string_view option, std::string_view name, RenderJob& job);

}  // namespace isolume
