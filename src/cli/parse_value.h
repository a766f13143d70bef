// The text after an option, turned into a value. Every failure is a UsageError that names the option, what it takes and
// what it got. Numbers are read the same in every locale; NaN, infinities and trailing letters are refused.
#pragma once

#include <fmt/core.h>

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "src/errors.h"
#include "src/jobs/color.h"
#include "src/suggest.h"

namespace isolume {

double parseNumber(std::string_view option, std::string_view text);
double parsePositive(std::string_view option, std::string_view text);
/// A number strictly between the two.
double parseBetween(std::string_view option, std::string_view text, double low, double high);
/// A number from `low` to `high`, both allowed.
double parseWithin(std::string_view option, std::string_view text, double low, double high);
/// A whole number from `low` to `high`, both allowed.
int parseCount(std::string_view option, std::string_view text, int low, int high);
/// Bytes: a whole number >= 0.
std::size_t parseBytes(std::string_view option, std::string_view text);
/// X,Y,Z
glm::dvec3 parseVector(std::string_view option, std::string_view text);
glm::dvec3 parsePositiveVector(std::string_view option, std::string_view text);
/// WxH, pixels.
glm::ivec2 parseSize(std::string_view option, std::string_view text);
/// XxYxZ or X,Y,Z, samples.
glm::ivec3 parseDims(std::string_view option, std::string_view text);
/// A name, #rrggbb, or r,g,b from 0 to 1; sRGB, as colours are written everywhere.
Color parseColor(std::string_view option, std::string_view text);
/// The comma-separated parts.
std::vector<std::string> splitList(std::string_view text, std::string_view separators = ",");

template <class T>
using Choices = std::vector<std::pair<std::string, T>>;

/// One of a few words.
template <class T>
T parseChoice(std::string_view option, std::string_view text, const Choices<T>& choices) {
  std::string list;
  std::vector<std::string> words;
  for (const auto& [word, value] : choices) {
    if (word == text) return value;
    list += (list.empty() ? "" : ", ") + word;
    words.push_back(word);
  }
  throw UsageError(fmt::format("{}: expected one of {}, found '{}'{}", option, list, text, didYouMean(text, words)));
}

}  // namespace isolume
