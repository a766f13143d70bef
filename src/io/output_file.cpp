#include "output_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <mutex>

#include "src/errors.h"
#include "unfinished_file.h"

namespace isolume {
namespace {

[[noreturn]] void fail(const std::string& path, const std::string& what, int error) {
  throw OutputError(fmt::format("{}: cannot {}: {}", path, what, std::strerror(error)));
}

std::string folderOf(const std::string& path) {
  const std::string folder = std::filesystem::path(path).parent_path().string();
  return folder.empty() ? "." : folder;
}

struct Target {
  std::string path;       // with symbolic links of an existing file resolved
  bool isStream = false;  // exists and is neither a file nor a folder: no renaming over it
};

// Finds out what stands under that name, and throws for whatever cannot be written.
Target inspect(const std::string& path) {
  if (path.empty()) throw OutputError("output: expected a file name, found an empty one");
  struct stat status {};
  Target target{path};
  if (stat(path.c_str(), &status) == 0) {
    if (S_ISDIR(status.st_mode)) fail(path, "write", EISDIR);
    if (access(path.c_str(), W_OK) != 0) fail(path, "write", errno);
    target.isStream = !S_ISREG(status.st_mode);
    if (target.isStream) return target;
    target.path = std::filesystem::canonical(path).string();
  } else if (errno != ENOENT) {
    fail(path, "write", errno);
  }
  const std::string folder = folderOf(target.path);
  const std::string what = fmt::format("create a file in folder {}", folder);
  if (stat(folder.c_str(), &status) != 0) fail(path, what, errno);
  if (!S_ISDIR(status.st_mode)) fail(path, what, ENOTDIR);
  if (access(folder.c_str(), W_OK | X_OK) != 0) fail(path, what, errno);
  return target;
}

void writeAll(const std::string& path, int descriptor, std::string_view bytes) {
  std::size_t done = 0;
  while (done < bytes.size()) {
    const ssize_t count = write(descriptor, bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) fail(path, fmt::format("write {} bytes, wrote {}", bytes.size(), done), errno);
    done += static_cast<std::size_t>(count);
  }
}

void writeStream(const std::string& path, std::string_view bytes) {
  const int descriptor = open(path.c_str(), O_WRONLY | O_CLOEXEC);
  if (descriptor < 0) fail(path, "open", errno);
  try {
    writeAll(path, descriptor, bytes);
  } catch (...) {
    close(descriptor);
    throw;
  }
  if (close(descriptor) != 0) fail(path, "close", errno);
}

// Hidden, in the target's folder, and not derived from its name, which may be as long as names can be. The clock tells
// processes with the same number on different machines apart.
std::string temporaryNameBeside(const std::string& path, int attempt) {
  const auto now = std::chrono::steady_clock::now().time_since_epoch().count();
  return fmt::format("{}/.isolume-{}-{:x}-{}.tmp", folderOf(path), getpid(), now, attempt);
}

void writeRegular(const std::string& path, const std::string& finalPath, std::string_view bytes) {
  static std::mutex oneAtATime;
  const std::lock_guard lock(oneAtATime);
  constexpr int kAttempts = 10;  // each fails only if a name with this process's number and this nanosecond exists
  for (int attempt = 0;; ++attempt) {
    UnfinishedFile file(temporaryNameBeside(finalPath, attempt));
    if (file.descriptor() < 0) {
      if (errno == EEXIST && attempt < kAttempts) continue;
      fail(path, fmt::format("create a file in folder {}", folderOf(finalPath)), errno);
    }
    writeAll(path, file.descriptor(), bytes);
    if (!file.close()) fail(path, "close", errno);
    if (!file.publish(finalPath)) fail(path, "rename the finished file to this name", errno);
    return;
  }
}

}  // namespace

void writeFileAtomically(const std::string& path, std::string_view bytes) {
  const Target target = inspect(path);
  if (target.isStream) {
    writeStream(path, bytes);
  } else {
    writeRegular(path, target.path, bytes);
  }
}

void checkWritable(const std::string& path) { inspect(path); }

}  // namespace isolume
