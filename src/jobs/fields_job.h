// `isolume fields`: the swept fields as VDB grids, which other tools read and `isolume render` starts from.
#pragma once

#include <string>

#include "src/jobs/run_options.h"
#include "src/jobs/surface.h"

namespace isolume {

struct FieldsJob {
  SurfaceRequest surface;
  std::string output;
  RunOptions run;
};

/// Nothing is written unless all went well. UsageError if the input is a fields file already.
void runFieldsJob(const FieldsJob& job);

}  // namespace isolume
