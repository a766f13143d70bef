// The command line as values: which command, with what; every option checked before any work starts.
#pragma once

#include <string>
#include <variant>

#include "src/jobs/compare_job.h"
#include "src/jobs/fields_job.h"
#include "src/jobs/info_job.h"
#include "src/jobs/reference_job.h"
#include "src/jobs/render_job.h"
#include "src/jobs/sample_job.h"

namespace isolume {

/// What --help and --version ask for: printed to standard output, and done.
struct PrintedText {
  std::string text;
};

using Command = std::variant<PrintedText, RenderJob, InfoJob, FieldsJob, SampleJob, ReferenceJob, CompareJob>;

/// UsageError for an unknown command or option ("did you mean"), a value that is not one, options that exclude each
/// other, and a missing input or output.
Command parseCommandLine(int argc, const char* const* argv);

}  // namespace isolume
