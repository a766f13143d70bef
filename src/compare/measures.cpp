#include "src/compare/measures.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>
#include <limits>

#include "sweep/parallel.h"

namespace isolume {
namespace {

/// difference(i) at the pixels that are compared.
void fill(DifferenceField& field, const LayerPair& pair, const std::function<double(std::size_t)>& difference) {
  const auto width = static_cast<std::size_t>(pair.size.x);
  field.size = pair.size;
  field.values.assign(pair.pixels.size(), std::numeric_limits<double>::quiet_NaN());
  parallelFor(static_cast<std::size_t>(pair.size.y), [&](std::size_t row) {
    for (std::size_t i = row * width; i < (row + 1) * width; ++i)
      if (pair.pixels[i] == kCompared) field.values[i] = difference(i);
  });
}

double angleDegrees(glm::dvec3 a, glm::dvec3 b) {
  const bool aIsZero = a == glm::dvec3(0), bIsZero = b == glm::dvec3(0);
  constexpr double kWorst = 180;
  if (aIsZero || bIsZero) return aIsZero && bIsZero ? 0 : kWorst;
  // Exact for small angles too, where the arc cosine of the dot product keeps half of the digits.
  return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

struct RowSums {
  std::size_t count = 0;
  double sum = 0, sumOfMagnitudes = 0, sumOfSquares = 0, max = -1;
  int maxX = 0;
};

RowSums sumRow(const DifferenceField& difference, std::size_t row) {
  RowSums sums;
  const auto width = static_cast<std::size_t>(difference.size.x);
  for (std::size_t x = 0; x < width; ++x) {
    const double d = difference.values[row * width + x], magnitude = std::abs(d);
    if (std::isnan(d)) continue;
    ++sums.count;
    sums.sum += d;
    sums.sumOfMagnitudes += magnitude;
    sums.sumOfSquares += d * d;
    if (magnitude <= sums.max) continue;
    sums.max = magnitude;
    sums.maxX = static_cast<int>(x);
  }
  return sums;
}

}  // namespace

DifferenceField channelDifference(const LayerPair& pair, const ChannelPair& channel) {
  DifferenceField field{channel.name, pair.layer == "Z" || pair.vector == "position" ? "world" : "", {}, {}};
  fill(field, pair,
       [&](std::size_t i) { return static_cast<double>(channel.got[i]) - static_cast<double>(channel.want[i]); });
  return field;
}

DifferenceField vectorDifference(const LayerPair& pair) {
  assert(pair.kind != LayerKind::values && pair.channels.size() == 3);
  const bool position = pair.kind == LayerKind::position;
  DifferenceField field{position ? "distance" : "angle", position ? "world" : "degrees", {}, {}};
  const std::vector<ChannelPair>& c = pair.channels;
  fill(field, pair, [&](std::size_t i) {
    const glm::dvec3 got(c[0].got[i], c[1].got[i], c[2].got[i]), want(c[0].want[i], c[1].want[i], c[2].want[i]);
    return position ? glm::distance(got, want) : angleDegrees(got, want);
  });
  return field;
}

Measures measure(const DifferenceField& difference) {
  std::vector<RowSums> rows(static_cast<std::size_t>(difference.size.y));
  parallelFor(rows.size(), [&](std::size_t row) { rows[row] = sumRow(difference, row); });
  RowSums total;
  Measures measures;
  for (std::size_t row = 0; row < rows.size(); ++row) {
    total.count += rows[row].count;
    total.sum += rows[row].sum;
    total.sumOfMagnitudes += rows[row].sumOfMagnitudes;
    total.sumOfSquares += rows[row].sumOfSquares;
    if (rows[row].max <= total.max) continue;
    total.max = rows[row].max;
    measures.maxPixel = {rows[row].maxX, static_cast<int>(row)};
  }
  if (total.count == 0) return measures;
  const auto n = static_cast<double>(total.count);
  measures.count = total.count;
  measures.rmse = std::sqrt(total.sumOfSquares / n);
  measures.bias = total.sum / n;
  measures.mean = total.sumOfMagnitudes / n;
  measures.max = total.max;
  constexpr int kHighPercent = 95;
  measures.p95 = magnitudePercentile(difference, kHighPercent);
  return measures;
}

double magnitudePercentile(const DifferenceField& difference, int percent) {
  assert(percent >= 1 && percent <= 100);
  std::vector<double> magnitudes;
  for (const double d : difference.values)
    if (!std::isnan(d)) magnitudes.push_back(std::abs(d));
  if (magnitudes.empty()) return 0;
  const std::size_t rank = (magnitudes.size() * static_cast<std::size_t>(percent) + 99) / 100;  // in whole numbers
  const auto nth = magnitudes.begin() + static_cast<std::ptrdiff_t>(rank - 1);
  std::nth_element(magnitudes.begin(), nth, magnitudes.end());
  return *nth;
}

std::optional<double> referenceNoise(const LayerPair& pair, const ChannelPair& channel) {
  if (channel.standardError.empty()) return std::nullopt;
  DifferenceField errors{channel.name, "", {}, {}};
  fill(errors, pair, [&](std::size_t i) { return static_cast<double>(channel.standardError[i]); });
  const Measures measures = measure(errors);
  if (measures.count == 0) return std::nullopt;
  return measures.rmse;
}

}  // namespace isolume
