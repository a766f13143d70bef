#include "src/cli/command_line.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <sstream>
#include <vector>

#include "src/cli/command_parser.h"
#include "src/cli/command_text.h"
#include "src/cli/compare_options.h"
#include "src/cli/render_options.h"
#include "src/errors.h"
#include "src/suggest.h"

namespace isolume {
namespace {

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

/// "render, info, fields or sample".
std::string nameList(const std::vector<std::string>& names) {
  std::string list = names.front();
  for (std::size_t i = 1; i < names.size(); ++i) list += (i + 1 < names.size() ? ", " : " or ") + names[i];
  return list;
}

[[noreturn]] void refuseWithoutCommand(const CommandParser& parser) {
  std::vector<std::string> names;
  for (const CLI::App* command : parser.commands) names.push_back(command->get_name());
  const std::vector<std::string> extras = parser.app.remaining();
  if (extras.empty()) throw UsageError(fmt::format("expected a command: {}; see isolume --help", nameList(names)));
  if (extras.front().starts_with('-')) refuseExtras(parser.app, "isolume");
  throw UsageError(fmt::format("unknown command '{}': expected {}{}", extras.front(), nameList(names),
                               didYouMean(extras.front(), names)));
}

Command checked(RenderJob& job) {
  checkOutput(job.output, job.surface.input, job.run, "render");
  checkRenderOptions(job);
  return job;
}

Command checked(InfoJob& job) {
  needInput(job.input, "info");
  return job;
}

Command checked(FieldsJob& job) {
  checkOutput(job.output, job.surface.input, job.run, "fields");
  if (!job.output.ends_with(".vdb"))
    throw UsageError(fmt::format("--output: expected a name that ends in .vdb, found '{}'", job.output));
  checkFields(job);
  return job;
}

Command checked(SampleJob& job) {
  if (job.name.empty())
    throw UsageError(fmt::format("sample: expected a name, one of {}, found none", sampleNameList()));
  needOutput(job.output, "sample");
  checkSample(job);
  return job;
}

Command checked(ReferenceJob& job) {
  checkOutput(job.output, job.surface.input, job.run, "reference");
  refuseSameFile(job.output, job.environment, "environment");
  checkReference(job);
  return job;
}

Command checked(CompareJob& job) {
  checkCompareOptions(job);
  return job;
}

Command chosenCommand(CommandParser& parser, const std::string& text) {
  const std::vector<CLI::App*> chosen = parser.app.get_subcommands();
  if (chosen.empty()) refuseWithoutCommand(parser);
  refuseExtras(parser.app, "isolume");
  const std::string name = chosen.front()->get_name();
  refuseExtras(*chosen.front(), name);
  for (RunOptions* run : {&parser.render.run, &parser.fields.run, &parser.reference.run, &parser.compare.run})
    run->command = text;
  if (name == "render") return checked(parser.render);
  if (name == "info") return checked(parser.info);
  if (name == "fields") return checked(parser.fields);
  if (name == "sample") return checked(parser.sample);
  if (name == "reference") return checked(parser.reference);
  return checked(parser.compare);
}

}  // namespace

Command parseCommandLine(int argc, const char* const* argv) {
  CommandParser parser;
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
