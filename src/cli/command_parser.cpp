#include "src/cli/command_parser.h"

#include "src/cli/compare_options.h"
#include "src/cli/option_builder.h"
#include "src/cli/ordinate_options.h"
#include "src/cli/parse_value.h"
#include "src/cli/reference_options.h"
#include "src/cli/render_options.h"
#include "src/cli/surface_options.h"
#include "src/version.h"

namespace isolume {
namespace {

constexpr std::size_t kHelpColumn = 26;  ///< where descriptions start, so that a line fits into 100 columns

constexpr const char* kExamples =
    "Examples:\n"
    "  isolume info skull_256x256x256_uint8.raw\n"
    "  isolume render skull_256x256x256_uint8.raw --isovalue 90 -o skull.png\n"
    "  isolume render scan.nii.gz --azimuth 60 --size 1920x1080 --samples 16 -o scan.png\n"
    "  isolume render smoke.vdb --layers all -o smoke.exr\n"
    "  isolume sample gyroid --size 128 -o gyroid.vdb\n"
    "  isolume reference smoke.vdb --stderr 0.002 -o truth.exr\n"
    "  isolume compare smoke.exr truth.exr --layer ambient --heat difference.png\n"
    "Exit codes: 0 done, 2 wrong usage, 3 bad input, 4 no OpenGL, 5 output not written, 6 a comparison\n"
    "beyond its limits, 130 interrupted.";

}  // namespace

CLI::App& CommandParser::add(const char* name, const char* description) {
  CLI::App* command = app.add_subcommand(name, description);
  command->group("Commands");
  commands.push_back(command);
  return *command;
}

void CommandParser::addSample() {
  CLI::App& command = add("sample", "make a sample volume");
  command.add_option("NAME", sample.name, "one of " + sampleNameList())->type_name("");
  OptionGroup output(command, "Output");
  output.value(
      "--size", "N",
      [this](const std::string& option, const std::string& text) {
        sample.size = parseCount(option, text, kMinSampleSize, kMaxSampleSize);
      },
      fmt::format("samples along each axis (default: {})", sample.size));
  addOutputOption(command, sample.output, "FILE", "volume to write: .vdb or .raw (float32, little-endian)");
  output.flag("--quiet", sample.quiet, "do not say how to render it");
}

CommandParser::CommandParser() {
  app.allow_extras();  // inherited by the commands: unknown words are told with a suggestion, not by the library
  app.get_formatter()->column_width(kHelpColumn);
  app.get_formatter()->label("SUBCOMMAND", "COMMAND");
  app.get_formatter()->label("Positionals", "Input");
  app.set_version_flag("--version", "isolume " + std::string(kVersion))->description("print the version and exit");
  app.set_help_flag("-h,--help", "print this and exit; of a command: `isolume render --help`");

  CLI::App& drawing = add("render", "draw the isosurface of a volume into a PNG or EXR");
  addSurfaceOptions(drawing, render.surface);
  addDistanceOptions(drawing, render.surface.distance, "band", "what is read");
  addRenderOptions(drawing, render);
  addRunOptions(drawing, render.run);

  CLI::App& telling = add("info", "print what is in a volume and the isovalue that render would take");
  addReadOptions(telling, info.input, info.read);
  OptionGroup(telling, "Output").flag("--json", info.json, "print as JSON");
  OptionGroup(telling, "Output").flag("--quiet", info.quiet, "no progress, notes or warnings");

  CLI::App& sweeping = add("fields", "save distance and octant visibility as VDB grids, for render to start from");
  addSurfaceOptions(sweeping, fields.surface);
  OptionGroup(sweeping, "Output")
      .value(
          "--with", "LIST",
          [this](const std::string& option, const std::string& text) {
            const Choices<bool OtherFields::*> choices{{"openness", &OtherFields::openness},
                                                       {"bent", &OtherFields::bent},
                                                       {"thickness", &OtherFields::thickness}};
            for (const std::string& name : splitList(text)) fields.others.*parseChoice(option, name, choices) = true;
          },
          "further grids, at the samples next to the surface:\nopenness,bent,thickness");
  addOrdinatesOption(sweeping, "Output", fields.occlusion, "directions that they are swept by");
  addTransportOptions(sweeping, "Output", fields.occlusion);
  addDistanceOptions(sweeping, fields.surface.distance, "full", "3 voxels");
  addOutputOption(sweeping, fields.output, "FILE", "VDB to write (.vdb)");
  addRunOptions(sweeping, fields.run);

  addSample();

  CLI::App& tracing = add("reference", "trace what render approximates: Monte Carlo, with standard errors");
  addSurfaceOptions(tracing, reference.surface);
  addReferenceOptions(tracing, reference);
  addRunOptions(tracing, reference.run);

  addCompareOptions(add("compare", "measure how far one picture is from another"), compare);

  app.footer(kExamples);
  for (CLI::App* each : commands) each->footer("")->set_help_flag("-h,--help", "print this and exit");
}

}  // namespace isolume
