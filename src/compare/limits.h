// What a comparison must keep to, and how it fails.
#pragma once

#include <optional>
#include <string>

#include "src/compare/comparison.h"

namespace isolume {

/// Limits that decide on the exit code; none of them set: only values that are not finite fail. A value at its limit
/// keeps it. In the unit of the first measure of the layer: degrees for directions, world units for positions.
struct CompareLimits {
  std::optional<double> maxRmse = {};
  std::optional<double> maxBias = {};  ///< of |bias|
  std::optional<double> maxMean = {}, maxP95 = {}, maxError = {};
  std::optional<double> minSsim = {};
  std::optional<double> maxMiss = {};  ///< a share in [0, 1], as PixelCounts::miss()
};

/// One line that names everything that is broken: measure, limit, value; "" if nothing is. A limit on a measure that
/// could not be taken, because no pixel is hit by both, is broken.
std::string brokenLimits(const Comparison& comparison, const CompareLimits& limits);

}  // namespace isolume
