#include "context.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <array>

#include "context_backends.h"
#include "gpu_error.h"

namespace isolume {
namespace {

struct Backend {
  std::string_view name;
  std::unique_ptr<Context> (*make)();
};
// EGL first: it is the only one that reaches a real GPU, it is what Mesa still develops, and without a GPU it ends at
// the same software rasteriser as OSMesa does.
constexpr std::array<Backend, 2> kBackends{{{"egl", makeEglContext}, {"osmesa", makeOsmesaContext}}};

std::string glString(GLenum name) {
  const auto* text = reinterpret_cast<const char*>(glGetString(name));
  return text ? text : "?";
}

std::unique_ptr<Context> makeAny() {
  std::string reasons;
  for (const Backend& backend : kBackends) {
    try {
      return backend.make();
    } catch (const GpuError& error) {
      reasons += fmt::format("{}{}", reasons.empty() ? "" : "; ", error.what());
    }
  }
  throw GpuError("no OpenGL 4.5 context: " + reasons);
}

}  // namespace

std::string Context::description() const {
  return fmt::format("{}, {}, {}", glString(GL_VENDOR), glString(GL_RENDERER), glString(GL_VERSION));
}

std::vector<std::string_view> backendNames() {
  std::vector<std::string_view> names;
  for (const Backend& backend : kBackends) names.push_back(backend.name);
  return names;
}

std::unique_ptr<Context> makeContext(std::string_view backend) {
  if (backend == "auto") return makeAny();
  std::string known = "auto";
  for (const Backend& candidate : kBackends) {
    if (candidate.name == backend) return candidate.make();
    known += fmt::format(", {}", candidate.name);
  }
  throw GpuError(fmt::format("backend: expected one of {}, found {}", known, backend));
}

void loadGl(std::string_view backend, GlFunction (*lookUp)(const char* name)) {
  const int version = gladLoadGL(lookUp);
  // The shaders and direct state access need it.
  constexpr int kMajor = 4, kMinor = 5;
  if (version >= GLAD_MAKE_VERSION(kMajor, kMinor)) return;
  if (version == 0) throw GpuError(fmt::format("{}: expected OpenGL {}.{}, found no OpenGL", backend, kMajor, kMinor));
  throw GpuError(fmt::format("{}: expected OpenGL {}.{}, found {}.{}", backend, kMajor, kMinor,
                             GLAD_VERSION_MAJOR(version), GLAD_VERSION_MINOR(version)));
}

}  // namespace isolume
