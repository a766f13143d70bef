// What goes wrong on the GPU side: no context, a shader that does not compile, a texture that does not fit.
#pragma once

#include <stdexcept>

namespace isolume {

/// One line: what, where, expected, found. The program exits with 4.
class GpuError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace isolume
