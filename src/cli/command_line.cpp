#include "src/cli/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <filesystem>
#include <sstream>
#include <vector>

#include "src/cli/command_text.h"
#include "src/cli/option_builder.h"
#include "src/cli/parse_value.h"
#include "src/cli/render_options.h"
#include "src/cli/surface_options.h"
#include "src/suggest.h"
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
    "Exit codes: 0 done, 2 wrong usage, 3 bad input, 4 no OpenGL, 5 output not written, 130 interrupted.";

/// The parser and what it fills in. Options hold references into it, so it stays where it is.
struct Parser {
  CLI::App app{"Isolume renders isosurfaces of volumes with swept ambient occlusion, without a window.", "isolume"};
  RenderJob render;
  InfoJob info;
  FieldsJob fields;
  SampleJob sample;
  std::array<CLI::App*, 4> commands{};

  Parser() {
    app.allow_extras();  // inherited by the commands: unknown words are told with a suggestion, not by the library
    app.get_formatter()->column_width(kHelpColumn);
    app.get_formatter()->label("SUBCOMMAND", "COMMAND");
    app.get_formatter()->label("Positionals", "Input");
    app.set_version_flag("--version", "isolume " + std::string(kVersion))->description("print the version and exit");
    app.set_help_flag("-h,--help", "print this and exit; of a command: `isolume render --help`");

    CLI::App* command = app.add_subcommand("render", "draw the isosurface of a volume into a PNG or EXR");
    command->group("Commands");
    addSurfaceOptions(*command, render.surface);
    addRenderOptions(*command, render);
    addRunOptions(*command, render.run);
    commands[0] = command;

    command = app.add_subcommand("info", "print what is in a volume and the isovalue that render would take");
    command->group("Commands");
    addReadOptions(*command, info.input, info.read);
    OptionGroup(*command, "Output").flag("--json", info.json, "print as JSON");
    OptionGroup(*command, "Output").flag("--quiet", info.quiet, "no progress, notes or warnings");
    commands[1] = command;

    command =
        app.add_subcommand("fields", "save distance and octant visibility as VDB grids, for render to start from");
    command->group("Commands");
    addSurfaceOptions(*command, fields.surface);
    addOutputOption(*command, fields.output, "FILE", "VDB to write (.vdb)");
    addRunOptions(*command, fields.run);
    commands[2] = command;

    command = app.add_subcommand("sample", "make one of six sample volumes");
    command->group("Commands");
    command->add_option("NAME", sample.name, "one of " + sampleNameList())->type_name("");
    OptionGroup(*command, "Output")
        .value(
            "--size", "N",
            [this](const std::string& option, const std::string& text) {
              sample.size = parseCount(option, text, kMinSampleSize, kMaxSampleSize);
            },
            fmt::format("samples along each axis (default: {})", sample.size));
    addOutputOption(*command, sample.output, "FILE", "volume to write: .vdb or .raw (float32, little-endian)");
    OptionGroup(*command, "Output").flag("--quiet", sample.quiet, "do not say how to render it");
    commands[3] = command;

    app.footer(kExamples);
    for (CLI::App* each : commands) each->footer("")->set_help_flag("-h,--help", "print this and exit");
  }
};

std::vector<std::string> longNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

/// The first word that nothing took.
void refuseExtras(const CLI::App& app, const std::string& command) {
  const std::vector<std::string> extras = app.remaining();
  if (extras.empty()) return;
  const auto isOption = [](const std::string& word) { return word.size() > 1 && word.front() == '-'; };
  const auto option = std::find_if(extras.begin(), extras.end(), isOption);
  if (option != extras.end()) {
    const std::string name = option->substr(0, option->find('='));
    throw UsageError(fmt::format("unknown option {}{}", name, didYouMean(name, longNames(app))));
  }
  throw UsageError(fmt::format("{}: expected nothing more, found '{}'", command, extras.front()));
}

/// The library leaves two empty lines between groups.
std::string withoutDoubleGaps(std::string text) {
  for (std::size_t at; (at = text.find("\n\n\n")) != std::string::npos;) text.erase(at, 1);
  return text;
}

std::string oneLine(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text;
}

void needInput(const std::string& input, const char* command) {
  if (input.empty())
    throw UsageError(fmt::format("{}: expected an input, found none; see isolume {} --help", command, command));
}

void needOutput(const std::string& output, const char* command) {
  if (output.empty()) throw UsageError(fmt::format("{}: expected an output, -o FILE, found none", command));
}

void refuseSameFile(const std::string& output, const std::string& other, const char* what) {
  if (other.empty()) return;
  std::error_code ignored;  // files that do not exist are different unless their names agree
  if (output == other || std::filesystem::equivalent(output, other, ignored))
    throw UsageError(fmt::format("--output: expected a file other than the {}, found '{}'", what, output));
}

void checkOutput(const std::string& output, const std::string& input, const RunOptions& run, const char* command) {
  needInput(input, command);
  needOutput(output, command);
  refuseSameFile(output, input, "input");
  refuseSameFile(output, run.report, "report");
}

Command chosenCommand(Parser& parser, const std::string& text) {
  const std::vector<CLI::App*> chosen = parser.app.get_subcommands();
  if (chosen.empty()) {
    std::vector<std::string> names;
    for (const CLI::App* command : parser.commands) names.push_back(command->get_name());
    const std::vector<std::string> extras = parser.app.remaining();
    if (extras.empty() || extras.front().starts_with('-')) refuseExtras(parser.app, "isolume");
    if (extras.empty()) throw UsageError("expected a command: render, info, fields or sample; see isolume --help");
    throw UsageError(fmt::format("unknown command '{}': expected render, info, fields or sample{}", extras.front(),
                                 didYouMean(extras.front(), names)));
  }
  refuseExtras(parser.app, "isolume");
  const CLI::App* command = chosen.front();
  refuseExtras(*command, command->get_name());
  if (command == parser.commands[0]) {
    RenderJob& job = parser.render;
    checkOutput(job.output, job.surface.input, job.run, "render");
    checkRenderOptions(job);
    job.run.command = text;
    return job;
  }
  if (command == parser.commands[1]) {
    needInput(parser.info.input, "info");
    return parser.info;
  }
  if (command == parser.commands[2]) {
    FieldsJob& job = parser.fields;
    checkOutput(job.output, job.surface.input, job.run, "fields");
    if (!job.output.ends_with(".vdb"))
      throw UsageError(fmt::format("--output: expected a name that ends in .vdb, found '{}'", job.output));
    job.run.command = text;
    return job;
  }
  SampleJob& job = parser.sample;
  if (job.name.empty())
    throw UsageError(fmt::format("sample: expected a name, one of {}, found none", sampleNameList()));
  needOutput(job.output, "sample");
  checkSample(job);
  return job;
}

}  // namespace

Command parseCommandLine(int argc, const char* const* argv) {
  Parser parser;
  try {
    parser.app.parse(argc, argv);
  } catch (const CLI::Success& asked) {  // --help, --version
    std::ostringstream out;
    parser.app.exit(asked, out, out);
    return PrintedText{withoutDoubleGaps(out.str())};
  } catch (const CLI::ArgumentMismatch& error) {
    // The only options that take something take one value, so there is either none or one too many.
    const std::string text = error.what();
    const bool none = text.find("missing") != std::string::npos || text.find("received 0") != std::string::npos;
    throw UsageError(text.substr(0, text.find(':')) +
                     (none ? ": expected a value, found none" : ": expected once, found it more than once"));
  } catch (const CLI::Error& error) {
    throw UsageError(oneLine(error.what()));
  }
  return chosenCommand(parser, commandText(argc, argv));
}

}  // namespace isolume
