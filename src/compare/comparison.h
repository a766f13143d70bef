// Everything that `isolume compare` tells of one layer of two pictures.
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "src/compare/layer_pair.h"
#include "src/compare/measures.h"

namespace isolume {

struct NamedMeasures {
  std::string name;  ///< channel, or "angle" or "distance"
  std::string unit;  ///< "degrees", "world" or ""
  Measures measures;
  /// RMS standard error of WANT (measures.h), and sqrt(max(0, rmse^2 - that^2)): the RMSE that is left when WANT's
  /// noise, independent of GOT and of mean 0, is taken out. None where WANT holds no standard error.
  std::optional<double> noise, rmseWithoutNoise;
};

struct PixelCounts {
  std::size_t all = 0;
  std::size_t both = 0;  ///< hit by both, with faulty pixels
  std::size_t gotOnly = 0, wantOnly = 0;
  std::size_t compared = 0;  ///< hit by both and finite
  /// Share of the pixels that either hits where only one does, in [0, 1]: does not change with the margin around the
  /// picture. 0 if neither hits anything.
  double miss() const;
};

struct Comparison {
  std::string layer, gotFile, wantFile, gotHitsFrom, wantHitsFrom;
  glm::ivec2 size{0};
  PixelCounts pixels;
  Faults faults;
  std::vector<std::string> notes;  ///< as of the LayerPair
  /// Of a vector, first its angle or distance, to which the limits apply, then its channels; otherwise the channels,
  /// and the limits apply to each of them.
  std::vector<NamedMeasures> measures;
  std::size_t limitedMeasures = 0;  ///< the limits apply to the first so many
  /// Mean over the channels (ssim.h), with L = 1 for values; 2 for X, Y and Z of a direction; for `position` and `Z`
  /// the range of WANT over the compared pixels and channels (1 if that is 0). None if nothing can be compared.
  std::optional<double> ssim;
};

/// O(pixels log n) at most. Bitwise the same for any number of threads.
Comparison compareLayer(const LayerPair& pair);

/// The difference that a heat map shows: angle, distance or the only channel. UsageError for a layer of several
/// channels that is no vector.
DifferenceField shownDifference(const LayerPair& pair);

/// For people; ends with a newline.
std::string comparisonText(const Comparison& comparison);

/// An object with `got`, `want`, `layer`, `size`, `hits_from` (`got`, `want`), `pixels` (`all`, `both`, `got_only`,
/// `want_only`, `compared`), `miss`, `faults` (`nan`, `infinite`), `notes`, `ssim`, `measures`: an array of `name`,
/// `unit`, `rmse`, `bias`, `mean`, `p95`, `max`, `max_pixel`, `reference_noise`, `rmse_without_noise`. What could not
/// be measured is null.
nlohmann::ordered_json comparisonJson(const Comparison& comparison);

}  // namespace isolume
