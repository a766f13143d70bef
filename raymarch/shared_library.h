// A library opened at run time, so that the program starts on machines that lack it.
#pragma once

#include <initializer_list>
#include <string>

namespace isolume {

/// Move-only; closes the library when destroyed.
class SharedLibrary {
 public:
  /// Opens the first of the names that exists. GpuError: "<purpose>: cannot open libX.so.1: <the system's reason>".
  SharedLibrary(const std::string& purpose, std::initializer_list<const char*> names);
  ~SharedLibrary();
  SharedLibrary(SharedLibrary&& other) noexcept;
  SharedLibrary& operator=(SharedLibrary&& other) noexcept;

  void* find(const char* symbol) const;  ///< nullptr if it has no such symbol
  /// GpuError if it has no such symbol.
  template <class Function>
  Function require(const char* symbol) const {
    return reinterpret_cast<Function>(requireSymbol(symbol));
  }

 private:
  void* requireSymbol(const char* symbol) const;

  std::string purpose_;
  std::string name_;
  void* handle_ = nullptr;
};

}  // namespace isolume
