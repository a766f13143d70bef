// `isolume compare`: how far one picture is from another, layer by layer.
#pragma once

#include <optional>
#include <string>

#include "src/compare/limits.h"
#include "src/jobs/run_options.h"

namespace isolume {

struct CompareJob {
  std::string got, want;          ///< EXR files with the layer and what tells hits (compare/layer_pair.h)
  std::string layer = "ambient";  ///< a layer (`ambient`, `normal`) or one channel (`ambient.Y`)
  std::string wantLayer;          ///< of WANT, if it has another name there; else ""
  CompareLimits limits;
  std::string heat;                 ///< PNG of the signed difference, or ""
  std::optional<double> heatRange;  ///< the colour scale ends at +- this; default: defaultHeatRange()
  bool json = false;                ///< print as JSON
  RunOptions run;
};

/// Prints the measures to standard output. LimitError (exit code 6) if a limit is broken or a value that is not finite
/// is found, after printing and after writing the heat map; InputError for files that cannot be compared
/// (compare/layer_pair.h).
void runCompareJob(const CompareJob& job);

}  // namespace isolume
