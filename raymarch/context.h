// An OpenGL 4.5 core context without a window, behind one interface; chosen at run time by name.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace isolume {

/// A current context. GL functions may be called on the creating thread while it lives; one at a time per thread.
class Context {
 public:
  virtual ~Context() = default;
  virtual std::string_view backend() const = 0;  ///< "osmesa" or "egl"
  std::string description() const;               ///< GL_VENDOR, GL_RENDERER, GL_VERSION in one line
};

/// Names for makeContext in the order in which "auto" tries them, without "auto" itself.
std::vector<std::string_view> backendNames();

/// Makes a context current. A named backend that is not available is a GpuError that says why; "auto" tries all of them
/// and the GpuError lists what each said. An unknown name is a GpuError as well.
std::unique_ptr<Context> makeContext(std::string_view backend = "auto");

}  // namespace isolume
