#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "src/jobs/info_job.h"

namespace isolume {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kRows = 16;  ///< rows of the histogram; divides its number of bins
/// Digits of lengths and values: those that a float32 carries. The isovalue is printed whole, to be given back.
constexpr int kDigits = 9;
constexpr double kBarLength = 40;  ///< letters of the longest bar

std::string row(const std::string& label, const std::string& text) { return fmt::format("  {:<11} {}\n", label, text); }

std::string shortNumber(const Json& value) { return fmt::format("{:.{}g}", value.get<double>(), kDigits); }

std::string numbers(const Json& list, const char* separator = " ") {
  std::string text;
  for (const Json& value : list)
    text += (text.empty() ? "" : separator) + (value.is_number_float() ? shortNumber(value) : value.dump());
  return text;
}

std::string text(const Json& value) { return value.get<std::string>(); }

/// Bars grow with the logarithm of the count, so that a peak of air does not hide everything else.
std::string histogramText(const Json& values) {
  const Json& bins = values["histogram"];
  const std::size_t binsPerRow = bins.size() / kRows;
  std::array<std::size_t, kRows> counts{};
  for (std::size_t i = 0; i < bins.size(); ++i) counts[i / binsPerRow] += bins[i].get<std::size_t>();
  const double longest = std::log1p(static_cast<double>(*std::max_element(counts.begin(), counts.end())));
  const double low = values["min"], high = values["max"];
  if (!(high > low) || longest == 0) return {};
  std::string out = "  histogram   (length of a bar: logarithm of the count)\n";
  for (std::size_t i = 0; i < kRows; ++i) {
    const double from = low + (high - low) * static_cast<double>(i) / kRows;
    const double to = low + (high - low) * static_cast<double>(i + 1) / kRows;
    const double length = std::round(kBarLength * std::log1p(static_cast<double>(counts[i])) / longest);
    out += fmt::format("  {:>12.6g} to {:>12.6g}  {:<40}  {}\n", from, to,
                       std::string(static_cast<std::size_t>(length), '#'), counts[i]);
  }
  return out;
}

std::string gridsText(const Json& grids) {
  std::string out;
  for (const Json& grid : grids) {
    out += row("grid", fmt::format("{}: {}, {}, {} active voxels from [{}] to [{}]", text(grid["name"]),
                                   text(grid["type"]), text(grid["kind"]), grid["active"].get<std::size_t>(),
                                   numbers(grid["index_min"]), numbers(grid["index_max"])));
    out += row("", text(grid["transform"]));
  }
  return out;
}

bool isIdentity(const Json& direction) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (direction[i][j].get<double>() != (i == j ? 1.0 : 0.0)) return false;
  return true;
}

std::string placementText(const Json& info) {
  std::string out =
      row("dimensions", fmt::format("{} ({} voxels)", numbers(info["dims"], " x "), info["voxels"].get<std::size_t>()));
  out += row("spacing", numbers(info["spacing"]));
  out += row("origin", numbers(info["origin"]));
  if (!isIdentity(info["direction"]))
    out += row("direction", fmt::format("x: {}; y: {}; z: {}", numbers(info["direction"][0]),
                                        numbers(info["direction"][1]), numbers(info["direction"][2])));
  out += row("extent", fmt::format("{}, from ({}) to ({})", numbers(info["extent"], " x "),
                                   numbers(info["bounds"]["min"], ", "), numbers(info["bounds"]["max"], ", ")));
  return out;
}

std::string valuesText(const Json& info) {
  const Json& values = info["values"];
  std::string out;
  const auto nan = values["nan"].get<std::size_t>(), inf = values["inf"].get<std::size_t>();
  if (!values.contains("min")) return row("values", fmt::format("none is finite: {} NaN, {} infinite", nan, inf));
  out += row("values", fmt::format("{} to {}, mean {}", shortNumber(values["min"]), shortNumber(values["max"]),
                                   shortNumber(values["mean"])));
  out += row("not finite", fmt::format("{} NaN, {} infinite{}", nan, inf, nan + inf > 0 ? " (count as outside)" : ""));
  out += row("isovalue", fmt::format("{} by default: {}; inside {}", info["isovalue"].get<double>(),
                                     text(info["isovalue_choice"]), text(info["inside"])));
  return out + histogramText(values);
}

}  // namespace

std::string infoText(const nlohmann::ordered_json& info) {
  std::string out = text(info["input"]) + "\n";
  out += row("format", text(info["format"]) + (info.contains("type") ? ", " + text(info["type"]) : ""));
  if (info.contains("grid")) out += row("shown grid", text(info["grid"]));
  if (info.contains("files") && info["files"].size() > 1)
    for (const Json& file : info["files"]) out += row("file", text(file));
  if (info.contains("grids")) out += gridsText(info["grids"]);
  if (!info.contains("dims")) return out + row("values", "choose one scalar grid with --grid NAME");
  out += placementText(info);
  if (info.contains("fields")) {
    const Json& fields = info["fields"];
    return out +
           row("fields", fmt::format("swept at isovalue {}, inside {}", fields["isovalue"].get<double>(),
                                     text(fields["inside"]))) +
           row("made by", text(fields["source"]));
  }
  const std::string world = text(info["world"]);
  out += row("world", world.empty() ? "the file does not say which; lengths are in its own units" : world);
  for (const Json& note : info["notes"]) out += row("note", text(note));
  return out + valuesText(info);
}

}  // namespace isolume
