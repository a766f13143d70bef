#include "sweep/reference/environment.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace isolume {
namespace {

using std::numbers::pi;

/// Relative luminance of linear Rec. 709 primaries.
constexpr glm::dvec3 kLuminance{0.2126, 0.7152, 0.0722};

/// Height (z) of the upper edge of a row.
double upperEdge(int row, int rows) { return std::cos(pi * row / rows); }

/// Where `value` falls into running sums; the last entry with a weight of its own at the most.
std::size_t findStep(const double* sums, std::size_t count, double value) {
  const double* found = std::upper_bound(sums, sums + count, value);
  if (found == sums + count) found = std::lower_bound(sums, sums + count, sums[count - 1]);
  return static_cast<std::size_t>(found - sums);
}

}  // namespace

Environment::Environment(glm::ivec2 size, std::vector<glm::vec3> radiance)
    : size_(size), radiance_(std::move(radiance)), weightUpTo_(radiance_.size()), rowWeightUpTo_(size.y) {
  assert(size.x > 0 && size.y > 0 && radiance_.size() == static_cast<std::size_t>(size.x) * size.y);
  const auto luminance = [this](std::size_t i) { return glm::dot(glm::dvec3(radiance_[i]), kLuminance); };
  const auto texelAngle = [size](int row) {
    return 2 * pi / size.x * (upperEdge(row, size.y) - upperEdge(row + 1, size.y));
  };
  double total = 0;
  bool even = true;
  for (int row = 0; row < size.y; ++row)
    for (int column = 0; column < size.x; ++column) {
      const std::size_t i = static_cast<std::size_t>(row) * size.x + column;
      total += luminance(i) * texelAngle(row);
      even = even && radiance_[i] == radiance_[0];
    }
  if (even) return;
  const double mean = total / (4 * pi);
  double drawn = 0;
  for (int row = 0; row < size.y; ++row) {
    double sum = 0;
    for (int column = 0; column < size.x; ++column) {
      const std::size_t i = static_cast<std::size_t>(row) * size.x + column;
      sum += std::max(luminance(i) - mean, 0.0) * texelAngle(row);
      weightUpTo_[i] = sum;
    }
    drawn += sum;
    rowWeightUpTo_[row] = drawn;
  }
  // Half at the most: directions about the normal must go on finding the dim rest.
  if (drawn > 0) drawnShare_ = std::min(drawn / total, 0.5);
}

std::size_t Environment::texelOf(glm::dvec3 direction) const {
  const double turn = 0.5 + std::atan2(direction.x, direction.y) / (2 * pi);
  const double fall = std::acos(std::clamp(direction.z, -1.0, 1.0)) / pi;
  const int column = std::min(static_cast<int>(turn * size_.x), size_.x - 1);
  const int row = std::min(static_cast<int>(fall * size_.y), size_.y - 1);
  return static_cast<std::size_t>(row) * size_.x + column;
}

glm::dvec3 Environment::radiance(glm::dvec3 direction) const { return radiance_[texelOf(direction)]; }

glm::dvec3 Environment::draw(glm::dvec2 u) const {
  assert(drawnShare_ > 0);
  const double target = u.y * rowWeightUpTo_.back();
  const std::size_t row = findStep(rowWeightUpTo_.data(), rowWeightUpTo_.size(), target);
  const double rowStart = row == 0 ? 0 : rowWeightUpTo_[row - 1];
  const double withinRow = std::clamp((target - rowStart) / (rowWeightUpTo_[row] - rowStart), 0.0, 1.0);

  const double* sums = &weightUpTo_[row * size_.x];
  const double columnTarget = u.x * sums[size_.x - 1];
  const std::size_t column = findStep(sums, size_.x, columnTarget);
  const double columnStart = column == 0 ? 0 : sums[column - 1];
  const double withinColumn = std::clamp((columnTarget - columnStart) / (sums[column] - columnStart), 0.0, 1.0);

  const double top = upperEdge(static_cast<int>(row), size_.y), bottom = upperEdge(static_cast<int>(row) + 1, size_.y);
  const double z = top + (bottom - top) * withinRow;
  const double angle = 2 * pi * ((static_cast<double>(column) + withinColumn) / size_.x - 0.5);
  const double across = std::sqrt(std::max(1 - z * z, 0.0));
  return {across * std::sin(angle), across * std::cos(angle), z};
}

double Environment::density(glm::dvec3 direction) const {
  if (drawnShare_ == 0) return 0;
  const std::size_t i = texelOf(direction), column = i % size_.x;
  const int row = static_cast<int>(i / size_.x);
  const double weight = weightUpTo_[i] - (column == 0 ? 0 : weightUpTo_[i - 1]);
  const double angle = 2 * pi / size_.x * (upperEdge(row, size_.y) - upperEdge(row + 1, size_.y));
  return weight / (rowWeightUpTo_.back() * angle);
}

}  // namespace isolume
