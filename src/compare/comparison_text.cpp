#include <fmt/format.h>

#include "src/compare/comparison.h"

namespace isolume {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kDigits = 5;  ///< significant, for people; JSON has them all
constexpr double kPercent = 100;

std::string number(double value) { return fmt::format("{:.{}g}", value, kDigits); }

std::string row(const std::string& label, const std::string& text) { return fmt::format("  {:<22} {}\n", label, text); }

std::string measuresText(const NamedMeasures& named) {
  const Measures& m = named.measures;
  std::string out = fmt::format("{}{}\n", named.name, named.unit.empty() ? "" : " (" + named.unit + ")");
  if (m.count == 0) return out + row("nothing to compare", "no pixel is hit by both and finite");
  out += row("RMSE", number(m.rmse));
  out += row("bias (got - want)", number(m.bias));
  out += row("mean |difference|", number(m.mean));
  out += row("95th percentile", number(m.p95));
  out += row("maximum", fmt::format("{} at pixel ({}, {})", number(m.max), m.maxPixel.x, m.maxPixel.y));
  if (!named.noise) return out;
  out += row("noise of want", fmt::format("{} (RMS standard error of the reference)", number(*named.noise)));
  return out + row("RMSE without noise", fmt::format("{} (sqrt(RMSE^2 - noise^2))", number(*named.rmseWithoutNoise)));
}

Json measuresJson(const NamedMeasures& named) {
  const Measures& m = named.measures;
  const auto orNull = [](bool known, const Json& value) { return known ? value : Json(); };
  const bool any = m.count > 0;
  return {{"name", named.name},
          {"unit", named.unit},
          {"rmse", orNull(any, m.rmse)},
          {"bias", orNull(any, m.bias)},
          {"mean", orNull(any, m.mean)},
          {"p95", orNull(any, m.p95)},
          {"max", orNull(any, m.max)},
          {"max_pixel", orNull(any, {m.maxPixel.x, m.maxPixel.y})},
          {"reference_noise", orNull(named.noise.has_value(), named.noise.value_or(0))},
          {"rmse_without_noise", orNull(named.noise.has_value(), named.rmseWithoutNoise.value_or(0))}};
}

}  // namespace

std::string comparisonText(const Comparison& comparison) {
  const PixelCounts& pixels = comparison.pixels;
  std::string out = fmt::format("{} of {} against {}, {} x {}\n", comparison.layer, comparison.gotFile,
                                comparison.wantFile, comparison.size.x, comparison.size.y);
  for (const std::string& note : comparison.notes) out += row("note", note);
  out += row("hit by both", fmt::format("{} of {} pixels (told by {} and {})", pixels.both, pixels.all,
                                        comparison.gotHitsFrom, comparison.wantHitsFrom));
  out += row("hit by one only", fmt::format("{} by got, {} by want: {} % of what either hits", pixels.gotOnly,
                                            pixels.wantOnly, number(kPercent * pixels.miss())));
  if (comparison.faults.nan + comparison.faults.infinite > 0)
    out += row("not finite", fmt::format("{} NaN, {} infinite values; {} pixels left out", comparison.faults.nan,
                                         comparison.faults.infinite, pixels.both - pixels.compared));
  out += row("SSIM", comparison.ssim ? number(*comparison.ssim) : "none: too few pixels hit by both side by side");
  for (const NamedMeasures& named : comparison.measures) out += measuresText(named);
  return out;
}

nlohmann::ordered_json comparisonJson(const Comparison& comparison) {
  const PixelCounts& pixels = comparison.pixels;
  Json measures = Json::array();
  for (const NamedMeasures& named : comparison.measures) measures.push_back(measuresJson(named));
  return {{"got", comparison.gotFile},
          {"want", comparison.wantFile},
          {"layer", comparison.layer},
          {"size", {comparison.size.x, comparison.size.y}},
          {"hits_from", {{"got", comparison.gotHitsFrom}, {"want", comparison.wantHitsFrom}}},
          {"pixels",
           {{"all", pixels.all},
            {"both", pixels.both},
            {"got_only", pixels.gotOnly},
            {"want_only", pixels.wantOnly},
            {"compared", pixels.compared}}},
          {"miss", pixels.miss()},
          {"faults", {{"nan", comparison.faults.nan}, {"infinite", comparison.faults.infinite}}},
          {"notes", comparison.notes},
          {"ssim", comparison.ssim ? Json(*comparison.ssim) : Json()},
          {"measures", measures}};
}

}  // namespace isolume
