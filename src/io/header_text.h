// Words and numbers of text headers.
#pragma once

#include <charconv>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isolume {

std::string_view trimmed(std::string_view text);  ///< without blanks, tabs and line ends around it
std::string lowerCase(std::string_view text);     ///< ASCII
std::vector<std::string_view> splitWords(std::string_view text, std::string_view separators = " \t");
std::vector<std::string_view> splitLines(std::string_view text);  ///< LF or CRLF

/// The whole of `text` as a number; nullopt for anything else, values out of range among them. Independent of locale.
template <class T>
std::optional<T> parseNumber(std::string_view text) {
  // from_chars takes no plus sign, which headers may have.
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  T value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

/// Exactly `count` numbers; nullopt for anything else.
template <class T>
std::optional<std::vector<T>> parseNumbers(std::string_view text, std::size_t count) {
  std::vector<T> numbers;
  for (const std::string_view word : splitWords(text)) {
    const auto number = parseNumber<T>(word);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  if (numbers.size() != count) return std::nullopt;
  return numbers;
}

/// A data file named in a header: relative names are relative to the header's folder.
std::string besideHeader(const std::string& headerPath, std::string_view dataName);

}  // namespace isolume
