#include "src/cli/parse_value.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>

#include "src/io/srgb.h"

namespace isolume {
namespace {

/// Largest side of a picture and of a volume that is accepted: image formats and GL count in 16 and 32 bits.
constexpr int kMaxSide = 65535;

template <class T>
std::optional<T> readWhole(std::string_view text) {
  if (text.size() > 1 && text.front() == '+' && text[1] != '-') text.remove_prefix(1);
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<double> readFinite(std::string_view text) {
  const std::optional<double> value = readWhole<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

[[noreturn]] void refuse(std::string_view option, std::string_view expected, std::string_view found) {
  throw UsageError(fmt::format("{}: expected {}, found '{}'", option, expected, found));
}

struct NamedColor {
  std::string_view name;
  std::uint32_t rgb;
};
/// The sixteen names of CSS 1 and both spellings of grey.
constexpr std::array<NamedColor, 17> kNamedColors{{{"white", 0xffffff},
                                                   {"black", 0x000000},
                                                   {"gray", 0x808080},
                                                   {"grey", 0x808080},
                                                   {"silver", 0xc0c0c0},
                                                   {"red", 0xff0000},
                                                   {"maroon", 0x800000},
                                                   {"yellow", 0xffff00},
                                                   {"olive", 0x808000},
                                                   {"lime", 0x00ff00},
                                                   {"green", 0x008000},
                                                   {"aqua", 0x00ffff},
                                                   {"teal", 0x008080},
                                                   {"blue", 0x0000ff},
                                                   {"navy", 0x000080},
                                                   {"fuchsia", 0xff00ff},
                                                   {"purple", 0x800080}}};

std::optional<glm::dvec3> srgbOf(std::string_view text) {
  const auto unpack = [](std::uint32_t rgb) {
    return glm::dvec3((rgb >> 16) & 0xff, (rgb >> 8) & 0xff, rgb & 0xff) / 255.0;
  };
  for (const NamedColor& named : kNamedColors)
    if (named.name == text) return unpack(named.rgb);
  if (text.size() == 7 && text.front() == '#') {
    std::uint32_t rgb = 0;
    const auto [end, error] = std::from_chars(text.data() + 1, text.data() + text.size(), rgb, 16);
    if (error == std::errc() && end == text.data() + text.size()) return unpack(rgb);
    return std::nullopt;
  }
  const std::vector<std::string> parts = splitList(text);
  if (parts.size() != 3) return std::nullopt;
  glm::dvec3 srgb{0};
  for (int i = 0; i < 3; ++i) {
    const std::optional<double> value = readFinite(parts[static_cast<std::size_t>(i)]);
    if (!value || *value < 0 || *value > 1) return std::nullopt;
    srgb[i] = *value;
  }
  return srgb;
}

}  // namespace

std::vector<std::string> splitList(std::string_view text, std::string_view separators) {
  std::vector<std::string> parts;
  for (;;) {
    const std::size_t end = text.find_first_of(separators);
    parts.emplace_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

double parseNumber(std::string_view option, std::string_view text) {
  const std::optional<double> value = readFinite(text);
  if (!value) refuse(option, "a finite number", text);
  return *value;
}

double parsePositive(std::string_view option, std::string_view text) {
  const std::optional<double> value = readFinite(text);
  if (!value || *value <= 0) refuse(option, "a number above 0", text);
  return *value;
}

double parseBetween(std::string_view option, std::string_view text, double low, double high) {
  const std::optional<double> value = readFinite(text);
  if (!value || *value <= low || *value >= high)
    refuse(option, fmt::format("a number between {} and {}", low, high), text);
  return *value;
}

double parseWithin(std::string_view option, std::string_view text, double low, double high) {
  const std::optional<double> value = readFinite(text);
  if (!value || *value < low || *value > high) refuse(option, fmt::format("a number from {} to {}", low, high), text);
  return *value;
}

int parseCount(std::string_view option, std::string_view text, int low, int high) {
  const std::optional<int> value = readWhole<int>(text);
  if (!value || *value < low || *value > high)
    refuse(option, fmt::format("a whole number from {} to {}", low, high), text);
  return *value;
}

std::size_t parseBytes(std::string_view option, std::string_view text) {
  const std::optional<std::size_t> value = readWhole<std::size_t>(text);
  if (!value) refuse(option, "a number of bytes, 0 or more", text);
  return *value;
}

glm::dvec3 parseVector(std::string_view option, std::string_view text) {
  const std::vector<std::string> parts = splitList(text);
  glm::dvec3 vector{0};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::optional<double> value = readFinite(parts[i]);
    if (parts.size() != 3 || !value) refuse(option, "three finite numbers X,Y,Z", text);
    vector[static_cast<int>(i)] = *value;
  }
  return vector;
}

glm::dvec3 parsePositiveVector(std::string_view option, std::string_view text) {
  const glm::dvec3 vector = parseVector(option, text);
  if (vector.x <= 0 || vector.y <= 0 || vector.z <= 0) refuse(option, "three numbers above 0, X,Y,Z", text);
  return vector;
}

glm::ivec2 parseSize(std::string_view option, std::string_view text) {
  const std::vector<std::string> parts = splitList(text, "x");
  const std::optional<int> width = parts.size() == 2 ? readWhole<int>(parts[0]) : std::nullopt;
  const std::optional<int> height = parts.size() == 2 ? readWhole<int>(parts[1]) : std::nullopt;
  if (!width || !height || *width < 1 || *height < 1 || *width > kMaxSide || *height > kMaxSide)
    refuse(option, fmt::format("WxH with sides from 1 to {} pixels, such as 1024x768", kMaxSide), text);
  return {*width, *height};
}

glm::ivec3 parseDims(std::string_view option, std::string_view text) {
  const std::vector<std::string> parts = splitList(text, text.find('x') == std::string_view::npos ? "," : "x");
  glm::ivec3 dims{0};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::optional<int> value = readWhole<int>(parts[i]);
    if (parts.size() != 3 || !value || *value < 1 || *value > kMaxSide)
      refuse(option, fmt::format("three sizes from 1 to {} samples, XxYxZ or X,Y,Z", kMaxSide), text);
    dims[static_cast<int>(i)] = *value;
  }
  return dims;
}

Color parseColor(std::string_view option, std::string_view text) {
  const std::optional<glm::dvec3> srgb = srgbOf(text);
  if (!srgb) {
    std::string names;
    for (const NamedColor& named : kNamedColors) names += std::string(named.name) + ", ";
    refuse(option, fmt::format("a colour: {}#rrggbb, or r,g,b from 0 to 1", names), text);
  }
  const glm::vec3 encoded(*srgb);
  return {std::string(text), {linearFromSrgb(encoded.r), linearFromSrgb(encoded.g), linearFromSrgb(encoded.b)}};
}

}  // namespace isolume
