// A file that is read by offset: checked once when it is opened, then readable from any thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace isolume {

/// InputError with the path and the reason if the path is missing, a folder, not a regular file, unreadable or empty.
class InputFile {
 public:
  explicit InputFile(const std::string& path);
  ~InputFile();
  InputFile(const InputFile&) = delete;
  InputFile& operator=(const InputFile&) = delete;

  const std::string& path() const { return path_; }
  std::uint64_t size() const { return size_; }

  /// Exactly `bytes` bytes from `offset`; InputError if the file ends sooner or the system fails. Thread-safe.
  void readAt(std::uint64_t offset, void* to, std::size_t bytes) const;

  /// The first bytes of the file, at most `limit`.
  std::string head(std::size_t limit) const;

 private:
  std::string path_;
  std::uint64_t size_ = 0;
  int descriptor_ = -1;
};

}  // namespace isolume
