#include "src/compare/limits.h"

#include <fmt/format.h>

#include <cmath>
#include <vector>

namespace isolume {
namespace {

/// Digits of what was found; more than the text shows, so that a value just beyond its limit does not look equal to it.
constexpr int kDigits = 9;

std::string broken(const std::string& what, const char* relation, double limit, double found) {
  return fmt::format("{}: expected {} {}, found {:.{}g}", what, relation, limit, found, kDigits);
}

void checkMeasures(const NamedMeasures& named, const CompareLimits& limits, std::vector<std::string>& list) {
  const Measures& m = named.measures;
  const auto check = [&](const char* measure, const std::optional<double>& limit, double found) {
    if (!limit) return;
    const std::string what = named.name + " " + measure;
    if (m.count == 0)
      list.push_back(fmt::format("{}: expected at most {}, found no pixel to compare", what, *limit));
    else if (found > *limit)
      list.push_back(broken(what, "at most", *limit, found));
  };
  check("RMSE", limits.maxRmse, m.rmse);
  check("|bias|", limits.maxBias, std::abs(m.bias));
  check("mean", limits.maxMean, m.mean);
  check("95th percentile", limits.maxP95, m.p95);
  check("maximum", limits.maxError, m.max);
}

}  // namespace

std::string brokenLimits(const Comparison& comparison, const CompareLimits& limits) {
  std::vector<std::string> list;
  const Faults& faults = comparison.faults;
  if (faults.nan + faults.infinite > 0)
    list.push_back(fmt::format(
        "{}: expected finite values where something is hit, found {} NaN and {} infinite, the first in {} at "
        "pixel ({}, {})",
        comparison.layer, faults.nan, faults.infinite, faults.firstFile, faults.firstPixel.x, faults.firstPixel.y));
  for (std::size_t i = 0; i < comparison.limitedMeasures; ++i) checkMeasures(comparison.measures[i], limits, list);
  if (limits.minSsim && !comparison.ssim)
    list.push_back(fmt::format("SSIM: expected at least {}, found too few pixels to compare", *limits.minSsim));
  if (limits.minSsim && comparison.ssim && *comparison.ssim < *limits.minSsim)
    list.push_back(broken("SSIM", "at least", *limits.minSsim, *comparison.ssim));
  if (limits.maxMiss && comparison.pixels.miss() > *limits.maxMiss)
    list.push_back(broken("share hit by one only", "at most", *limits.maxMiss, comparison.pixels.miss()));
  if (list.empty()) return {};
  return fmt::format("{} against {}: {}", comparison.gotFile, comparison.wantFile, fmt::join(list, "; "));
}

}  // namespace isolume
