#include "tests/bench/report/report_program.h"

#include <fmt/core.h>

#include <cstdio>
#include <exception>

#include "raymarch/gpu_error.h"
#include "src/errors.h"

namespace isolume::bench {
namespace {

int fail(const CLI::App& app, int code, const char* what) {
  fmt::print(stderr, "{}: error: {}\n", app.get_name(), what);
  return code;
}

}  // namespace

int runReportProgram(CLI::App& app, int argc, char** argv, const std::function<nlohmann::ordered_json()>& work) {
  constexpr int kIndent = 2;
  enum ExitCode { kDefect = 1, kUsage = 2, kInput = 3, kGpu = 4, kOutput = 5 };
  try {
    app.parse(argc, argv);
    fmt::print("{}\n", work().dump(kIndent));
    return 0;
  } catch (const CLI::Success& asked) {
    return app.exit(asked);
  } catch (const CLI::Error& error) {
    return fail(app, kUsage, error.what());
  } catch (const UsageError& error) {
    return fail(app, kUsage, error.what());
  } catch (const InputError& error) {
    return fail(app, kInput, error.what());
  } catch (const GpuError& error) {
    return fail(app, kGpu, error.what());
  } catch (const OutputError& error) {
    return fail(app, kOutput, error.what());
  } catch (const std::exception& error) {
    return fail(app, kDefect, error.what());
  }
}

}  // namespace isolume::bench
