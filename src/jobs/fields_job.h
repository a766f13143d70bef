// `isolume fields`: the swept fields as VDB grids, which other tools read and `isolume render` starts from.
#pragma once

#include <string>

#include "src/jobs/occlusion_method.h"
#include "src/jobs/run_options.h"
#include "src/jobs/surface.h"

namespace isolume {

/// Grids beside level, distance and octants; each a number per sample next to the surface, 0 elsewhere.
struct OtherFields {
  bool openness = false;   ///< `openness`
  bool bent = false;       ///< `bent_x` `_y` `_z`, unit, world, and `cone`, radians
  bool thickness = false;  ///< `thickness`, world units
  bool any() const { return openness || bent || thickness; }
};

struct FieldsJob {
  SurfaceRequest surface;
  std::string output;
  OtherFields others;
  OcclusionRequest occlusion;  ///< of `others`: ordinates, and for openness their transport
  RunOptions run;
};

/// UsageError for options that contradict each other or the fields that are wanted.
void checkFields(const FieldsJob& job);

/// Nothing is written unless all went well. UsageError if the input is a fields file already.
void runFieldsJob(const FieldsJob& job);

}  // namespace isolume
