#include "src/cli/compare_options.h"

#include <filesystem>
#include <limits>
#include <system_error>

#include "src/cli/option_builder.h"
#include "src/cli/parse_value.h"

namespace isolume {
namespace {

/// As for the other commands (surface_options.cpp).
constexpr int kMaxThreads = 1024;

void addLimitOptions(CLI::App& app, CompareLimits& limits) {
  OptionGroup group(app, "Limits (none by default; exit code 6 if one is broken)");
  const auto number = [&group](const std::string& flag, const std::string& value, std::optional<double>& target,
                               auto parse, const std::string& description) {
    group.value(
        flag, value,
        [&target, parse](const std::string& option, const std::string& text) { target = parse(option, text); },
        description);
  };
  const auto atLeastZero = [](const std::string& option, const std::string& text) {
    return parseWithin(option, text, 0, std::numeric_limits<double>::max());
  };
  const auto share = [](const std::string& option, const std::string& text) { return parseWithin(option, text, 0, 1); };
  const auto similarity = [](const std::string& option, const std::string& text) {
    return parseWithin(option, text, -1, 1);
  };
  number("--max-rmse", "E", limits.maxRmse, atLeastZero, "root mean square of the difference");
  number("--max-bias", "E", limits.maxBias, atLeastZero, "magnitude of the mean difference");
  number("--max-mean", "E", limits.maxMean, atLeastZero, "mean magnitude of the difference");
  number("--max-p95", "E", limits.maxP95, atLeastZero, "95th percentile of the magnitude");
  number("--max-error", "E", limits.maxError, atLeastZero, "largest magnitude");
  number("--min-ssim", "S", limits.minSsim, similarity, "structural similarity, 1 for the same picture");
  number("--max-miss", "SHARE", limits.maxMiss, share,
         "of the pixels that either hits, those that only one\ndoes, 0 to 1");
}

bool isSameFile(const std::string& a, const std::string& b) {
  std::error_code ignored;  // files that do not exist are different unless their names agree
  return a == b || std::filesystem::equivalent(a, b, ignored);
}

}  // namespace

void addCompareOptions(CLI::App& app, CompareJob& job) {
  app.add_option("GOT", job.got, "the picture to judge: an EXR with layers")->type_name("");
  app.add_option("WANT", job.want, "the picture to judge it by, of the same size")->type_name("");
  OptionGroup what(app, "What");
  what.value(
      "--layer", "NAME", [&job](const std::string&, const std::string& text) { job.layer = text; },
      "layer or channel: ambient, normal, position, Z,\nnormal.X, ... (default: " + job.layer + ")");
  what.value(
      "--against", "NAME", [&job](const std::string&, const std::string& text) { job.wantLayer = text; },
      "channel of WANT, if it has another name there:\n--layer irradiance.G --against ambient.Y");
  addLimitOptions(app, job.limits);
  OptionGroup output(app, "Output");
  output.flag("--json", job.json, "print as JSON");
  output.value(
      "--heat", "FILE.png", [&job](const std::string&, const std::string& text) { job.heat = text; },
      "draw got - want: blue below 0, orange above");
  output.value(
      "--heat-range", "R",
      [&job](const std::string& option, const std::string& text) { job.heatRange = parsePositive(option, text); },
      "ends of its colour scale (default: the 99th percentile\nof the magnitude, rounded up to one digit)");
  OptionGroup(app, "Running")
      .value(
          "--threads", "N",
          [&job](const std::string& option, const std::string& text) {
            job.run.threads = parseCount(option, text, 1, kMaxThreads);
          },
          "most threads; changes no bit of the result (default:\nall cores)");
}

void checkCompareOptions(const CompareJob& job) {
  if (job.got.empty() || job.want.empty())
    throw UsageError(fmt::format("compare: expected two pictures, GOT and WANT, found {}",
                                 job.got.empty() ? "none" : "one; see isolume compare --help"));
  if (job.layer.empty()) throw UsageError("--layer: expected a name, found none");
  if (job.heatRange && job.heat.empty())
    throw UsageError("--heat-range: expected --heat FILE.png beside it, found none");
  if (job.heat.empty()) return;
  if (std::filesystem::path(job.heat).extension() != ".png")
    throw UsageError(fmt::format("--heat: expected a name that ends in .png, found '{}'", job.heat));
  for (const std::string& picture : {job.got, job.want})
    if (isSameFile(job.heat, picture))
      throw UsageError(fmt::format("--heat: expected a file other than the pictures, found '{}'", job.heat));
}

}  // namespace isolume
