#include "image_codec.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <future>
#include <stdexcept>

#include "image_codec_module.h"

namespace isolume {
namespace {

constexpr const char* kModuleName = "isolume_image_codec.so";

// Relative to the program's folder: beside it in a build tree, one up for the tests of a build tree and for bin/ of an
// installation, and there in the library folder that the installation was configured with.
constexpr std::array kFolders{"lib/isolume", "../lib/isolume", "../" ISOLUME_INSTALL_LIBDIR "/isolume"};

const ImageCodec* load() {
  namespace fs = std::filesystem;
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path();
  std::string tried;
  for (const char* folder : kFolders) {
    const fs::path file = (program / folder).lexically_normal() / kModuleName;
    void* module = fs::exists(file) ? dlopen(file.c_str(), RTLD_LAZY | RTLD_LOCAL) : nullptr;
    const auto entry =
        module ? reinterpret_cast<decltype(&isolumeImageCodec)>(dlsym(module, "isolumeImageCodec")) : nullptr;
    if (entry) return entry();
    const char* reason = fs::exists(file) ? dlerror() : nullptr;
    tried += fmt::format("{}{}", tried.empty() ? "" : ", ", reason ? reason : file.parent_path().string());
  }
  throw std::runtime_error(fmt::format("{}: expected in one of: {}; found none", kModuleName, tried));
}

// The future's destructor, at exit, waits for a load that is still running.
std::shared_future<const ImageCodec*>& loading() {
  static std::shared_future<const ImageCodec*> future = std::async(std::launch::async, load).share();
  return future;
}

}  // namespace

const ImageCodec& imageCodec() { return *loading().get(); }

void preloadImageCodec() { loading(); }

}  // namespace isolume
