#include "tests/bench/report/report_program.h"

#include <fmt/core.h>

#include "src/cli/run.h"
#include "src/errors.h"

namespace isolume::bench {

int runReportProgram(CLI::App& app, int argc, char** argv, const std::function<nlohmann::ordered_json()>& work) {
  constexpr int kIndent = 2;
  return runReporting(app.get_name(), [&] {
    try {
      app.parse(argc, argv);
    } catch (const CLI::Success& asked) {
      return app.exit(asked);
    } catch (const CLI::Error& error) {
      throw UsageError(error.what());
    }
    fmt::print("{}\n", work().dump(kIndent));
    return 0;
  });
}

}  // namespace isolume::bench
