// `isolume compare`: how far one picture is from another, layer by layer.
#pragma once

#include <optional>
#include <string>

#include "src/jobs/run_options.h"

namespace isolume {

/// Limits that decide on the exit code; none of them set: the numbers are printed, and only NaN fails.
struct CompareLimits {
  std::optional<double> maxRmse, maxBias, maxMean, maxP95, maxError, minSsim, maxMiss;
};

struct CompareJob {
  std::string got, want;          ///< EXR files with the layer and `position` or `Z` (which tell where something is hit)
  std::string layer = "ambient";  ///< a layer (`ambient`, `normal`) or one channel (`ambient.Y`)
  CompareLimits limits;
  std::string heat;  ///< PNG of the signed difference, or ""
  std::optional<double> heatRange;  ///< the colour scale ends at +- this; default: the 99th percentile of |difference|
  bool json = false;                ///< print as JSON
  RunOptions run;
};

/// Prints the measures to standard output. LimitError (exit code 6) if a limit is broken or a NaN is found, after
/// printing and after writing the heat map; InputError for files that cannot be compared (size, layer missing).
void runCompareJob(const CompareJob& job);

}  // namespace isolume
