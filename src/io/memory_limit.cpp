#include "memory_limit.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <glm/gtc/type_precision.hpp>
#include <limits>
#include <optional>

#include "errors.h"

namespace isolume {
namespace {

constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();

/// The number behind `key` in a file of "key number" lines; the first number of the file for an empty key.
std::optional<std::uint64_t> numberIn(const std::filesystem::path& file, const std::string& key) {
  std::ifstream in(file);
  for (std::string word; in >> word;) {
    std::uint64_t number = 0;
    if (key.empty()) {
      // "max" means no limit.
      if (word.find_first_not_of("0123456789") != std::string::npos) return std::nullopt;
      return std::stoull(word);
    }
    if (word == key && in >> number) return number;
  }
  return std::nullopt;
}

/// What one control group leaves: its limit less its use, not counting file cache that the kernel gives back.
std::uint64_t leftInGroup(const std::filesystem::path& folder, const char* limitFile, const char* useFile,
                          const char* cacheKey) {
  const auto limit = numberIn(folder / limitFile, "");
  const auto use = numberIn(folder / useFile, "");
  if (!limit || !use) return kUnlimited;
  const std::uint64_t cache = numberIn(folder / "memory.stat", cacheKey).value_or(0);
  const std::uint64_t held = *use > cache ? *use - cache : 0;
  return *limit > held ? *limit - held : 0;
}

std::uint64_t leftInGroups() {
  const std::filesystem::path root = "/sys/fs/cgroup";
  std::uint64_t left =
      leftInGroup(root / "memory", "memory.limit_in_bytes", "memory.usage_in_bytes", "total_inactive_file");
  std::ifstream groups("/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    // Version 2 lists one line, "0::/path"; every folder from there to the root may set a limit.
    if (!line.starts_with("0::/")) continue;
    for (std::filesystem::path group = line.substr(3);; group = group.parent_path()) {
      left = std::min(left, leftInGroup(root / group.relative_path(), "memory.max", "memory.current", "inactive_file"));
      if (!group.has_relative_path()) break;
    }
  }
  return left;
}

}  // namespace

std::uint64_t availableMemory() {
  constexpr std::uint64_t kBytesPerKib = 1024;
  const auto system = numberIn("/proc/meminfo", "MemAvailable:");
  return std::min(system ? *system * kBytesPerKib : kUnlimited, leftInGroups());
}

std::string formatBytes(std::uint64_t bytes) {
  constexpr std::array kUnits{"bytes", "KiB", "MiB", "GiB", "TiB", "PiB", "EiB"};
  constexpr double kStep = 1024;
  auto value = static_cast<double>(bytes);
  std::size_t unit = 0;
  for (; value >= kStep && unit + 1 < kUnits.size(); ++unit) value /= kStep;
  return unit == 0 ? fmt::format("{} bytes", bytes) : fmt::format("{:.1f} {}", value, kUnits[unit]);
}

void requireMemory(const std::string& path, glm::i64vec3 size, std::uint64_t bytesPerSample) {
  std::uint64_t bytes = bytesPerSample;
  bool overflow = false;
  for (int axis = 0; axis < 3; ++axis)
    overflow |= __builtin_mul_overflow(bytes, static_cast<std::uint64_t>(size[axis]), &bytes);
  const std::uint64_t available = availableMemory();
  if (!overflow && bytes <= available) return;
  throw InputError(fmt::format("{}: {}x{}x{} samples need {} of memory, found {} available", path, size.x, size.y,
                               size.z, overflow ? "more than 16 EiB" : formatBytes(bytes), formatBytes(available)));
}

}  // namespace isolume
