#include "input_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "errors.h"

namespace isolume {

InputFile::InputFile(const std::string& path) : path_(path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0)
    throw InputError(fmt::format("{}: cannot be read: {}", path, std::strerror(errno)));
  if (S_ISDIR(status.st_mode)) throw InputError(fmt::format("{}: expected a file, found a folder", path));
  // Opening a pipe would wait for a writer, and none of them can be read by offset.
  if (!S_ISREG(status.st_mode))
    throw InputError(fmt::format("{}: expected a regular file, found a device, pipe or socket", path));
  size_ = static_cast<std::uint64_t>(status.st_size);
  if (size_ == 0) throw InputError(fmt::format("{}: expected a volume, found an empty file (0 bytes)", path));
  descriptor_ = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor_ < 0) throw InputError(fmt::format("{}: cannot be read: {}", path, std::strerror(errno)));
}

InputFile::~InputFile() { close(descriptor_); }

void InputFile::readAt(std::uint64_t offset, void* to, std::size_t bytes) const {
  auto* next = static_cast<char*>(to);
  const std::uint64_t end = offset + bytes;
  while (offset < end) {
    const ssize_t got = pread(descriptor_, next, end - offset, static_cast<off_t>(offset));
    if (got < 0 && errno == EINTR) continue;
    if (got < 0) throw InputError(fmt::format("{}: read failed at byte {}: {}", path_, offset, std::strerror(errno)));
    if (got == 0) throw InputError(fmt::format("{}: expected at least {} bytes, found {}", path_, end, offset));
    next += got;
    offset += static_cast<std::uint64_t>(got);
  }
}

std::string InputFile::head(std::size_t limit) const {
  std::string bytes(static_cast<std::size_t>(std::min<std::uint64_t>(size_, limit)), '\0');
  readAt(0, bytes.data(), bytes.size());
  return bytes;
}

}  // namespace isolume
