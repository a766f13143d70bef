#include "shared_library.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <utility>

#include "gpu_error.h"

namespace isolume {

SharedLibrary::SharedLibrary(const std::string& purpose, std::initializer_list<const char*> names) : purpose_(purpose) {
  std::string reason;
  for (const char* name : names) {
    handle_ = dlopen(name, RTLD_NOW | RTLD_LOCAL);
    if (handle_) {
      name_ = name;
      return;
    }
    // The first name is the one expected; the reason for it is the one worth telling.
    if (reason.empty()) reason = dlerror();
  }
  throw GpuError(fmt::format("{}: cannot open {}: {}", purpose_, *names.begin(), reason));
}

SharedLibrary::~SharedLibrary() {
  if (handle_) dlclose(handle_);
}

SharedLibrary::SharedLibrary(SharedLibrary&& other) noexcept
    : purpose_(std::move(other.purpose_)),
      name_(std::move(other.name_)),
      handle_(std::exchange(other.handle_, nullptr)) {}

SharedLibrary& SharedLibrary::operator=(SharedLibrary&& other) noexcept {
  std::swap(purpose_, other.purpose_);
  std::swap(name_, other.name_);
  std::swap(handle_, other.handle_);
  return *this;
}

void* SharedLibrary::find(const char* symbol) const { return dlsym(handle_, symbol); }

void* SharedLibrary::requireSymbol(const char* symbol) const {
  void* address = find(symbol);
  if (!address) throw GpuError(fmt::format("{}: {} has no function {}", purpose_, name_, symbol));
  return address;
}

}  // namespace isolume
