#include "raw.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>

#include "byte_order_hint.h"
#include "errors.h"
#include "header_text.h"
#include "placement.h"
#include "raw_samples.h"

namespace isolume {
namespace {

constexpr std::string_view kRawTypes = "uint8 int8 uint16 int16 uint32 int32 float32 float64";

struct NamedLayout {
  std::optional<glm::i64vec3> dims;
  std::optional<SampleType> type;
  std::optional<bool> bigEndian;
  bool contradictory = false;  ///< two sizes or two types
};

std::optional<SampleType> rawTypeNamed(std::string_view name) {
  const auto words = splitWords(kRawTypes);
  return std::find(words.begin(), words.end(), name) == words.end() ? std::nullopt : sampleTypeNamed(name);
}

std::optional<glm::i64vec3> parseDims(std::string_view word) {
  const bool plain = std::all_of(word.begin(), word.end(), [](char c) { return (c >= '0' && c <= '9') || c == 'x'; });
  const auto parts = splitWords(word, "x");
  if (!plain || parts.size() != 3 || word.starts_with('x') || word.ends_with('x') || word.find("xx") != word.npos)
    return std::nullopt;
  glm::i64vec3 dims;
  for (int axis = 0; axis < 3; ++axis) {
    const auto number = parseNumber<std::int64_t>(parts[static_cast<std::size_t>(axis)]);
    if (!number) return std::nullopt;
    dims[axis] = *number;
  }
  return dims;
}

/// Words of the name between `_`, `-`, `.` and blanks; a byte order counts only right behind the type.
NamedLayout layoutOfName(const std::string& path) {
  NamedLayout layout;
  const std::string stem = lowerCase(std::filesystem::path(path).stem().string());
  bool afterType = false;
  for (const std::string_view word : splitWords(stem, "_-. ")) {
    const auto dims = parseDims(word);
    const auto type = rawTypeNamed(word);
    layout.contradictory |=
        (dims && layout.dims && *dims != *layout.dims) || (type && layout.type && *type != *layout.type);
    if (dims) layout.dims = dims;
    if (type) layout.type = type;
    if (afterType && (word == "be" || word == "le")) layout.bigEndian = word == "be";
    afterType = type.has_value();
  }
  return layout;
}

}  // namespace

bool isRawName(const std::string& path) {
  const NamedLayout layout = layoutOfName(path);
  return layout.dims && layout.type;
}

Volume readRaw(const std::string& path, const RawLayout& layout) {
  const NamedLayout named = layoutOfName(path);
  if (named.contradictory && !(layout.dims && layout.type))
    throw InputError(
        fmt::format("{}: expected one size and one type in the name, found two; say --dims and --type", path));
  const std::string example = "a name like skull_256x256x108_int16.raw";
  if (!layout.dims && !named.dims)
    throw InputError(fmt::format("{}: dimensions unknown: expected --dims 256x256x108 or {}", path, example));
  if (!layout.type && !named.type)
    throw InputError(
        fmt::format("{}: sample type unknown: expected --type int16 (one of {}) or {}", path, kRawTypes, example));
  RawDescription d{.dataPath = path};
  d.dims = layout.dims ? glm::i64vec3(*layout.dims) : *named.dims;
  if (layout.type) {
    const auto type = rawTypeNamed(*layout.type);
    if (!type)
      throw InputError(fmt::format("{}: --type: expected one of {}, found '{}'", path, kRawTypes, *layout.type));
    d.type = *type;
  } else {
    d.type = *named.type;
  }
  d.bigEndian = layout.bigEndian.value_or(named.bigEndian.value_or(false));
  d.offset = layout.offset.value_or(0);
  const glm::dvec3 spacing = layout.spacing.value_or(glm::dvec3(1));
  for (int axis = 0; axis < 3; ++axis)
    if (!(spacing[axis] > 0) || !std::isfinite(spacing[axis]))
      throw InputError(fmt::format("{}: --spacing: expected three numbers above 0, found {} {} {}", path, spacing.x,
                                   spacing.y, spacing.z));
  d.worldFromGrid = placeGrid(path, spacing, glm::dmat3(1), layout.origin.value_or(glm::dvec3(0)));

  Volume volume = readRawSamples(d);
  volume.format = "raw";
  if (const std::string hint = byteOrderHint(d); !hint.empty()) volume.notes.push_back(hint);
  std::vector<std::string> fromName;
  if (!layout.dims) fromName.push_back(fmt::format("{}x{}x{}", d.dims.x, d.dims.y, d.dims.z));
  if (!layout.type) fromName.emplace_back(sampleTypeName(d.type));
  if (!layout.bigEndian && named.bigEndian) fromName.emplace_back(d.bigEndian ? "big-endian" : "little-endian");
  if (layout.dims && named.dims && d.dims != *named.dims)
    volume.notes.push_back(fmt::format("--dims {}x{}x{} wins over the file's name, which says {}x{}x{}", d.dims.x,
                                       d.dims.y, d.dims.z, named.dims->x, named.dims->y, named.dims->z));
  if (layout.type && named.type && d.type != *named.type)
    volume.notes.push_back(fmt::format("--type {} wins over the file's name, which says {}", sampleTypeName(d.type),
                                       sampleTypeName(*named.type)));
  if (!fromName.empty()) volume.notes.push_back(fmt::format("{} taken from the file's name", fmt::join(fromName, " ")));
  return volume;
}

}  // namespace isolume
