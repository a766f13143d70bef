#include "open_plane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "sweep/grid.h"
#include "sweep/octants.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

// Heights from below the ramp up to where nothing of the plane is felt, in steps a good deal finer than the ramp.
constexpr double kLowest = -1, kHighest = 24, kStep = 0.125;
constexpr int kHeights = static_cast<int>((kHighest - kLowest) / kStep) + 1;
using Heights = std::array<double, kHeights>;

double at(const Heights& values, double height) {
  const double place = (height - kLowest) / kStep;
  if (place <= 0) return values.front();
  if (place >= kHeights - 1) return 1;
  const int below = static_cast<int>(place);
  const auto i = static_cast<std::size_t>(below);
  return values[i] + (place - below) * (values[i + 1] - values[i]);
}

// Passes from the top down, which is the way that light takes but for an axis that leads down, until nothing changes.
Heights solve(glm::dvec3 move, glm::dvec3 weight) {
  constexpr int kMostPasses = 200;
  constexpr double kSettled = 1e-5;
  Heights values;
  values.fill(1);
  for (int pass = 0; pass < kMostPasses; ++pass) {
    double change = 0;
    for (int k = kHeights - 1; k >= 0; --k) {
      const double height = kLowest + k * kStep;
      double sum = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const double from = height + move[axis];
        sum += weight[axis] * std::clamp(from + 0.5, 0.0, 1.0) * at(values, from);
      }
      double& value = values[static_cast<std::size_t>(k)];
      change = std::max(change, std::abs(value - sum));
      value = sum;
    }
    if (change < kSettled) break;
  }
  return values;
}

// The mean of trilinear reading: each axis spreads a point over its neighbours by a hat of its spacing. Five points of
// the hat, at thirds, have its variance of 1/6.
double readAt(const Heights& values, double height, glm::dvec3 move) {
  constexpr std::array<double, 5> kPlace{-2.0 / 3, -1.0 / 3, 0, 1.0 / 3, 2.0 / 3};
  constexpr std::array<double, 5> kShare{1.0 / 8, 1.0 / 4, 1.0 / 4, 1.0 / 4, 1.0 / 8};
  double sum = 0;
  for (std::size_t x = 0; x < kPlace.size(); ++x)
    for (std::size_t y = 0; y < kPlace.size(); ++y)
      for (std::size_t z = 0; z < kPlace.size(); ++z)
        sum += kShare[x] * kShare[y] * kShare[z] *
               at(values, height + kPlace[x] * move.x + kPlace[y] * move.y + kPlace[z] * move.z);
  return sum;
}

}  // namespace

double openPlaneVisibility(glm::dvec3 sigma, glm::dvec3 normal, glm::dvec3 spacing, double offset) {
  const glm::dvec3 h = spacing / smallestSpacing(spacing);
  const glm::dvec3 weight = (1.0 / h) / (1 / h.x + 1 / h.y + 1 / h.z);
  const glm::dvec3 move = sigma * normal * h;
  if (glm::dot(weight, move) <= 0) return 0;
  const double height = offset * glm::dot(normal * normal, h);
  return readAt(solve(move, weight), height, move);
}

double openPlaneOpenness(glm::dvec3 normal, glm::dvec3 spacing, double offset) {
  double sum = 0;
  for (int s = 0; s < kOctantCount; ++s) {
    const glm::dvec3 sigma(kOctants[static_cast<std::size_t>(s)].towardsLight());
    sum += octantGeometryTerm(s, normal) * openPlaneVisibility(sigma, normal, spacing, offset);
  }
  return sum / std::numbers::pi;
}

double OpenPlaneTable::at(glm::dvec3 normal) const {
  const glm::dvec3 n = glm::abs(normal);
  constexpr int kLast = kOpenPlaneSize - 1;
  const double scale = kLast / std::sqrt(1 + n.z);
  const glm::dvec2 place = glm::min(glm::dvec2(n) * scale, glm::dvec2(kLast));
  const glm::ivec2 low = glm::min(glm::ivec2(place), glm::ivec2(kLast - 1));
  const glm::dvec2 part = place - glm::dvec2(low);
  const float* row = openness.data() + low.y * kOpenPlaneSize + low.x;
  return glm::mix(glm::mix<double>(row[0], row[1], part.x),
                  glm::mix<double>(row[kOpenPlaneSize], row[kOpenPlaneSize + 1], part.x), part.y);
}

OpenPlaneTable makeOpenPlaneTable(glm::dvec3 spacing, double offset) {
  OpenPlaneTable table;
  constexpr auto kSize = static_cast<std::size_t>(kOpenPlaneSize);
  table.openness.resize(kSize * kSize);
  parallelFor(kSize * kSize, [&](std::size_t i) {
    const double x = static_cast<double>(i % kSize) / (kSize - 1), y = static_cast<double>(i / kSize) / (kSize - 1);
    // Beyond the rim the normal of the rim's continuation below the horizon, mirrored up, would be another: the rim's.
    const double square = x * x + y * y, rim = square > 1 ? 1 / std::sqrt(square) : 1;
    const double z = std::max(0.0, 1 - square);
    const double scale = rim * std::sqrt(1 + z);
    table.openness[i] = static_cast<float>(openPlaneOpenness(glm::dvec3(x * scale, y * scale, z), spacing, offset));
  });
  return table;
}

void divideByOpenPlane(GeometryTermTables& terms, const OpenPlaneTable& plane) {
  const auto size = static_cast<std::size_t>(terms.size);
  parallelFor(size, [&](std::size_t row) {
    for (std::size_t column = 0; column < size; ++column) {
      const double x = 2 * static_cast<double>(column) / (terms.size - 1) - 1;
      const double y = 2 * static_cast<double>(row) / (terms.size - 1) - 1;
      const double z = 1 - (x * x + y * y), scale = std::sqrt(1 + z);
      const auto factor = static_cast<float>(1 / plane.at(glm::normalize(glm::dvec3(x * scale, y * scale, z))));
      for (auto& texels : terms.texels) texels[row * size + column] *= factor;
    }
  });
}

}  // namespace isolume
