// EGL without a window or a surface. Tried in order: each hardware device (EGL_EXT_platform_device), Mesa's surfaceless
// platform, each software device. Surfaceless alone would miss a GPU whose driver is not Mesa's, and take Mesa's
// software rasteriser beside it.

#include <fmt/format.h>
#include <glad/egl.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "context_backends.h"
#include "gpu_error.h"
#include "shared_library.h"

namespace isolume {
namespace {

constexpr std::string_view kBackend = "egl";

using GetProcAddress = GlFunction (*)(const char* name);

// The functions of EGL 1.4, which the library exports, and of the extensions, which it does not; those may be nullptr.
// (glad's own EGL loader would ask for the default display, which is an X server's.)
struct EglApi {
  SharedLibrary library{std::string(kBackend), {"libEGL.so.1", "libEGL.so"}};
  GetProcAddress getProcAddress = library.require<GetProcAddress>("eglGetProcAddress");
  PFNEGLGETERRORPROC getError = library.require<PFNEGLGETERRORPROC>("eglGetError");
  PFNEGLQUERYSTRINGPROC queryString = library.require<PFNEGLQUERYSTRINGPROC>("eglQueryString");
  PFNEGLINITIALIZEPROC initialize = library.require<PFNEGLINITIALIZEPROC>("eglInitialize");
  PFNEGLTERMINATEPROC terminate = library.require<PFNEGLTERMINATEPROC>("eglTerminate");
  PFNEGLBINDAPIPROC bindApi = library.require<PFNEGLBINDAPIPROC>("eglBindAPI");
  PFNEGLCHOOSECONFIGPROC chooseConfig = library.require<PFNEGLCHOOSECONFIGPROC>("eglChooseConfig");
  PFNEGLCREATECONTEXTPROC createContext = library.require<PFNEGLCREATECONTEXTPROC>("eglCreateContext");
  PFNEGLDESTROYCONTEXTPROC destroyContext = library.require<PFNEGLDESTROYCONTEXTPROC>("eglDestroyContext");
  PFNEGLMAKECURRENTPROC makeCurrent = library.require<PFNEGLMAKECURRENTPROC>("eglMakeCurrent");
  PFNEGLRELEASETHREADPROC releaseThread = library.require<PFNEGLRELEASETHREADPROC>("eglReleaseThread");
  PFNEGLQUERYDEVICESEXTPROC queryDevices = extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  PFNEGLQUERYDEVICESTRINGEXTPROC queryDeviceString =
      extension<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
  PFNEGLGETPLATFORMDISPLAYEXTPROC getPlatformDisplay =
      extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");

 private:
  template <class Function>
  Function extension(const char* name) const {
    return reinterpret_cast<Function>(getProcAddress(name));
  }
};

// Opened once and never closed: drivers leave threads behind.
const EglApi& egl() {
  static const auto* api = new EglApi;
  return *api;
}

bool hasExtension(const char* list, std::string_view name) {
  if (!list) return false;
  std::string_view rest = list;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    if (rest.substr(0, end) == name) return true;
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  return false;
}

struct Platform {
  std::string name;
  EGLenum platform;
  void* nativeDisplay;
};

std::vector<Platform> devicePlatforms(const char* clientExtensions, bool software) {
  std::vector<Platform> platforms;
  if (!hasExtension(clientExtensions, "EGL_EXT_platform_device") || !egl().queryDevices || !egl().queryDeviceString)
    return platforms;
  EGLint count = 0;
  if (!egl().queryDevices(0, nullptr, &count) || count <= 0) return platforms;
  std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
  if (!egl().queryDevices(count, devices.data(), &count)) return platforms;
  for (EGLint i = 0; i < count; ++i) {
    EGLDeviceEXT device = devices[static_cast<std::size_t>(i)];
    if (hasExtension(egl().queryDeviceString(device, EGL_EXTENSIONS), "EGL_MESA_device_software") == software) {
      platforms.push_back({fmt::format("device {}", i), EGL_PLATFORM_DEVICE_EXT, device});
    }
  }
  return platforms;
}

std::vector<Platform> candidatePlatforms() {
  const char* extensions = egl().queryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  std::vector<Platform> platforms = devicePlatforms(extensions, false);
  if (hasExtension(extensions, "EGL_MESA_platform_surfaceless")) {
    platforms.push_back({"surfaceless", EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY});
  }
  for (Platform& platform : devicePlatforms(extensions, true)) platforms.push_back(std::move(platform));
  return platforms;
}

class EglContext : public Context {
 public:
  explicit EglContext(const Platform& platform) {
    display_ = egl().getPlatformDisplay(platform.platform, platform.nativeDisplay, nullptr);
    if (display_ == EGL_NO_DISPLAY) fail(platform, "no display");
    EGLint major = 0, minor = 0;
    if (!egl().initialize(display_, &major, &minor)) {
      display_ = EGL_NO_DISPLAY;
      fail(platform, "cannot be initialised");
    }
    try {
      createCurrent(platform);
    } catch (...) {
      release();
      throw;
    }
  }
  ~EglContext() override { release(); }
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  std::string_view backend() const override { return kBackend; }

 private:
  [[noreturn]] static void fail(const Platform& platform, std::string_view what) {
    throw GpuError(fmt::format("{} {}: {}, error {:#06x}", kBackend, platform.name, what, egl().getError()));
  }

  void createCurrent(const Platform& platform) {
    if (!hasExtension(egl().queryString(display_, EGL_EXTENSIONS), "EGL_KHR_surfaceless_context")) {
      fail(platform, "expected EGL_KHR_surfaceless_context, found no such extension");
    }
    if (!egl().bindApi(EGL_OPENGL_API)) fail(platform, "no desktop OpenGL");
    constexpr std::array<EGLint, 5> kConfig{EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!egl().chooseConfig(display_, kConfig.data(), &config, 1, &count) || count == 0)
      fail(platform, "no configuration");
    constexpr std::array<EGLint, 7> kAttributes{
        EGL_CONTEXT_MAJOR_VERSION,           4,       EGL_CONTEXT_MINOR_VERSION, 5, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    context_ = egl().createContext(display_, config, EGL_NO_CONTEXT, kAttributes.data());
    if (context_ == EGL_NO_CONTEXT) fail(platform, "no OpenGL 4.5 core context");
    if (!egl().makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
      fail(platform, "context not made current");
    loadGl(kBackend, egl().getProcAddress);
  }

  void release() {
    if (display_ == EGL_NO_DISPLAY) return;
    egl().makeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (context_ != EGL_NO_CONTEXT) egl().destroyContext(display_, context_);
    egl().terminate(display_);
    egl().releaseThread();
    display_ = EGL_NO_DISPLAY;
  }

  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<Context> makeEglContext() {
  if (!egl().getPlatformDisplay) throw GpuError("egl: expected EGL_EXT_platform_base, found no such extension");
  std::string reasons;
  for (const Platform& platform : candidatePlatforms()) {
    try {
      return std::make_unique<EglContext>(platform);
    } catch (const GpuError& error) {
      reasons += fmt::format("{}{}", reasons.empty() ? "" : "; ", error.what());
    }
  }
  throw GpuError(reasons.empty() ? "egl: expected a device or the surfaceless platform, found neither" : reasons);
}

}  // namespace isolume
