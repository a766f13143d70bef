#include "src/cli/run.h"

#include <fmt/core.h>

#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <variant>

#include "raymarch/gpu_error.h"
#include "src/cli/command_line.h"
#include "src/errors.h"
#include "src/io/output_file.h"

namespace isolume {
namespace {

enum ExitCode { kSuccess = 0, kDefect = 1, kUsage = 2, kInput = 3, kGpu = 4, kOutput = 5, kLimit = 6 };

struct JobRunner {
  void operator()(const PrintedText& text) const { fmt::print("{}", text.text); }
  void operator()(const RenderJob& job) const { runRenderJob(job); }
  void operator()(const InfoJob& job) const { runInfoJob(job); }
  void operator()(const FieldsJob& job) const { runFieldsJob(job); }
  void operator()(const SampleJob& job) const { runSampleJob(job); }
  void operator()(const ReferenceJob& job) const { runReferenceJob(job); }
  void operator()(const CompareJob& job) const { runCompareJob(job); }
};

}  // namespace

int runReporting(const std::string& name, const std::function<int()>& work) {
  const auto report = [&name](ExitCode code, std::string_view what) -> int {
    fmt::print(stderr, "{}: error: {}\n", name, what);
    return code;
  };
  try {
    return work();
  } catch (const UsageError& error) {
    return report(kUsage, error.what());
  } catch (const InputError& error) {
    return report(kInput, error.what());
  } catch (const GpuError& error) {
    return report(kGpu, error.what());
  } catch (const OutputError& error) {
    return report(kOutput, error.what());
  } catch (const LimitError& error) {
    return report(kLimit, error.what());
  } catch (const std::bad_alloc&) {
    return report(kInput, "out of memory: the volume and its fields need more than this machine can give");
  } catch (const std::exception& error) {
    return report(kDefect, fmt::format("unexpected: {}", error.what()));
  }
}

int runProgram(int argc, char** argv) {
  installInterruptHandler();
  return runReporting("isolume", [&] {
    std::visit(JobRunner{}, parseCommandLine(argc, argv));
    if (std::fflush(stdout) != 0) throw OutputError("standard output: cannot write");
    return static_cast<int>(kSuccess);
  });
}

}  // namespace isolume
