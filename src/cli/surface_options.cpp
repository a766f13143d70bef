#include "src/cli/surface_options.h"

#include "src/cli/option_builder.h"
#include "src/cli/parse_value.h"

namespace isolume {
namespace {

/// More threads than any machine of today has cores, and few enough that a slip of the finger is caught.
constexpr int kMaxThreads = 1024;

Choices<std::string> sampleTypes() {
  Choices<std::string> choices;
  for (const char* type : {"uint8", "int8", "uint16", "int16", "uint32", "int32", "float32", "float64"})
    choices.emplace_back(type, type);
  return choices;
}

}  // namespace

void addReadOptions(CLI::App& app, std::string& input, ReadOptions& target) {
  app.add_option("INPUT", input, "a volume: VDB, raw, .mhd, .nhdr, or anything that the build's ITK reads")
      ->type_name("");
  OptionGroup volume(app, "Volume");
  volume.value(
      "--grid", "NAME", [&](const std::string&, const std::string& text) { target.grid = text; },
      "grid of a VDB, NAME or NAME[i] (default: the only scalar one)");
  OptionGroup raw(app, "Raw files (default: as the name says, e.g. x_256x256x108_int16[_be].raw)");
  raw.value(
      "--dims", "XxYxZ",
      [&](const std::string& option, const std::string& text) { target.raw.dims = parseDims(option, text); },
      "samples along each axis, x fastest");
  raw.value(
      "--type", "TYPE",
      [&](const std::string& option, const std::string& text) {
        target.raw.type = parseChoice(option, text, sampleTypes());
      },
      "uint8, int8, uint16, int16, uint32, int32, float32 or float64");
  raw.value(
      "--endian", "ORDER",
      [&](const std::string& option, const std::string& text) {
        target.raw.bigEndian = parseChoice<bool>(option, text, {{"little", false}, {"big", true}});
      },
      "byte order, little or big (default: little)");
  raw.value(
      "--offset", "BYTES",
      [&](const std::string& option, const std::string& text) { target.raw.offset = parseBytes(option, text); },
      "bytes to skip before the first sample (default: 0)");
  raw.value(
      "--spacing", "X,Y,Z",
      [&](const std::string& option, const std::string& text) {
        target.raw.spacing = parsePositiveVector(option, text);
      },
      "distance between samples, world units (default: 1,1,1)");
  raw.value(
      "--origin", "X,Y,Z",
      [&](const std::string& option, const std::string& text) { target.raw.origin = parseVector(option, text); },
      "world position of sample (0,0,0) (default: 0,0,0)");
}

void addSurfaceOptions(CLI::App& app, SurfaceRequest& target) {
  OptionGroup surface(app, "Surface");
  surface.value(
      "--isovalue", "V",
      [&](const std::string& option, const std::string& text) { target.isovalue = parseNumber(option, text); },
      "value at the surface (default: as `isolume info` prints)");
  surface.value(
      "--inside", "SIDE",
      [&](const std::string& option, const std::string& text) {
        target.inside = parseChoice<std::optional<Inside>>(
            option, text, {{"above", Inside::above}, {"below", Inside::below}, {"auto", std::nullopt}});
      },
      "solid side: above, below or auto (default: auto, which is\nbelow for a VDB level set, above otherwise)");
  addReadOptions(app, target.input, target.read);
}

void addDistanceOptions(CLI::App& app, DistanceRequest& target, const std::string& defaultExtent,
                        const std::string& band) {
  OptionGroup group(app, "Distance");
  group.value(
      "--solver", "NAME",
      [&](const std::string& option, const std::string& text) {
        target.solver = parseChoice<DistanceSolver>(
            option, text, {{"godunov", DistanceSolver::godunov}, {"closest", DistanceSolver::closest}});
      },
      "godunov, the first-order sweep, or closest, exact next\nto the surface and slower (default: godunov)");
  group.value(
      "--start", "NAME",
      [&](const std::string& option, const std::string& text) {
        target.start = parseChoice<DistanceStart>(option, text,
                                                  {{"paper", DistanceStart::paper}, {"better", DistanceStart::better}});
      },
      "where godunov starts: paper, nearest crossed grid edge,\nor better, from the interpolant (default: better)");
  group.value(
      "--extent", "KIND",
      [&](const std::string& option, const std::string& text) {
        target.extent =
            parseChoice<DistanceExtent>(option, text, {{"band", DistanceExtent::band}, {"full", DistanceExtent::full}});
      },
      "band: " + band +
          " about the surface, a safe lower bound\nbeyond; or full, the whole grid (default: " + defaultExtent + ")");
}

void addOutputOption(CLI::App& app, std::string& target, const std::string& valueName, const std::string& description) {
  OptionGroup(app, "Output")
      .value(
          "-o,--output", valueName, [&](const std::string&, const std::string& text) { target = text; }, description);
}

void addRunOptions(CLI::App& app, RunOptions& target) {
  OptionGroup run(app, "Running");
  run.value(
      "--threads", "N",
      [&](const std::string& option, const std::string& text) {
        target.threads = parseCount(option, text, 1, kMaxThreads);
      },
      "most threads, also of software GL; changes no bit of the\nresult (default: all cores)");
  run.value(
      "--report", "FILE.json", [&](const std::string&, const std::string& text) { target.report = text; },
      "write time and memory of each stage as JSON");
  run.flag("--verbose", target.verbose, "print them to standard error");
  run.flag("--quiet", target.quiet, "no progress, notes or warnings");
}

}  // namespace isolume
