// What the program reports and exits with: one line naming what, where, expected and found.
#pragma once

#include <stdexcept>

namespace isolume {

/// A wrong command line. Exit code 2.
struct UsageError : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// A file that cannot be read, or data that cannot be rendered. Exit code 3.
struct InputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// An output that cannot be written. Exit code 5 (4 is GpuError, raymarch/gpu_error.h).
struct OutputError : std::runtime_error {
  using std::runtime_error::runtime_error;
};
/// A comparison that exceeds a limit the user set, or meets a NaN. Exit code 6.
struct LimitError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace isolume
