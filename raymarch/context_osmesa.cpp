// OSMesa: Mesa's software rasteriser without any window system or device. Mesa 25.1 dropped it, so this file alone
// knows of it, and the library is opened at run time. What follows of its interface is stable since 2015.

#include <glad/gl.h>

#include <array>
#include <memory>

#include "context_backends.h"
#include "gpu_error.h"
#include "shared_library.h"

namespace isolume {
namespace {

using OsmesaHandle = struct osmesa_context*;
// Names and values of GL/osmesa.h.
constexpr int kOsmesaFormat = 0x22, kOsmesaProfile = 0x33, kOsmesaCoreProfile = 0x34;
constexpr int kOsmesaMajor = 0x36, kOsmesaMinor = 0x37, kOsmesaRgba = GL_RGBA;

using CreateContext = OsmesaHandle (*)(const int* attributes, OsmesaHandle share);
using DestroyContext = void (*)(OsmesaHandle);
using MakeCurrent = GLboolean (*)(OsmesaHandle, void* buffer, GLenum type, GLsizei width, GLsizei height);
using GetProcAddress = GlFunction (*)(const char* name);

struct OsmesaApi {
  SharedLibrary library{"osmesa", {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"}};
  CreateContext create = library.require<CreateContext>("OSMesaCreateContextAttribs");
  DestroyContext destroy = library.require<DestroyContext>("OSMesaDestroyContext");
  MakeCurrent makeCurrent = library.require<MakeCurrent>("OSMesaMakeCurrent");
  GetProcAddress getProcAddress = library.require<GetProcAddress>("OSMesaGetProcAddress");
};

// Never closed once open: Mesa's worker threads may outlive a context.
const OsmesaApi& osmesaApi() {
  static const auto* api = new OsmesaApi;
  return *api;
}

class OsmesaContext : public Context {
 public:
  OsmesaContext() : api_(osmesaApi()) {
    constexpr std::array<int, 9> kAttributes{
        kOsmesaFormat, kOsmesaRgba, kOsmesaProfile, kOsmesaCoreProfile, kOsmesaMajor, 4, kOsmesaMinor, 5, 0};
    handle_ = api_.create(kAttributes.data(), nullptr);
    if (!handle_) throw GpuError("osmesa: expected an OpenGL 4.5 core context, found that this Mesa makes none");
    // The context wants a default framebuffer; pictures are drawn into textures, so one pixel does.
    if (!api_.makeCurrent(handle_, pixel_.data(), GL_UNSIGNED_BYTE, 1, 1)) {
      api_.destroy(handle_);
      throw GpuError("osmesa: the new context cannot be made current");
    }
    try {
      loadGl("osmesa", api_.getProcAddress);
    } catch (...) {
      release();
      throw;
    }
  }
  ~OsmesaContext() override { release(); }
  OsmesaContext(const OsmesaContext&) = delete;
  OsmesaContext& operator=(const OsmesaContext&) = delete;

  std::string_view backend() const override { return "osmesa"; }

 private:
  void release() {
    api_.makeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
    api_.destroy(handle_);
  }

  const OsmesaApi& api_;
  OsmesaHandle handle_ = nullptr;
  std::array<unsigned char, 4> pixel_{};
};

}  // namespace

std::unique_ptr<Context> makeOsmesaContext() { return std::make_unique<OsmesaContext>(); }

}  // namespace isolume
