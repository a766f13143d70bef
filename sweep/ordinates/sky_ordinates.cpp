#include "sky_ordinates.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>

#include "ordinate_set.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

using std::numbers::pi;

/// Blocks of the map go to the closest ordinate as a whole: so many along each axis, .7 degrees wide. Larger texels are
/// cut into parts.
constexpr glm::ivec2 kBlocks{512, 256};

/// Integral of L w dw over a part of the sky, by colour.
using LightVector = std::array<glm::dvec3, 3>;

/// Integral of w dw over a texel: columns between two angles about z from +y towards +x, rows between two angles from
/// +z.
glm::dvec3 directionIntegral(double left, double right, double top, double bottom) {
  const auto ring = [](double fall) { return fall / 2 - std::sin(2 * fall) / 4; };  // integral of sin^2
  const double across = ring(bottom) - ring(top);
  const double up = (std::pow(std::sin(bottom), 2) - std::pow(std::sin(top), 2)) / 2;
  return {across * (std::cos(left) - std::cos(right)), across * (std::sin(right) - std::sin(left)),
          up * (right - left)};
}

std::size_t closest(const std::vector<glm::dvec3>& directions, glm::dvec3 to) {
  std::size_t best = 0;
  double largest = -2;
  for (std::size_t k = 0; k < directions.size(); ++k) {
    const double cosine = glm::dot(directions[k], to);
    if (cosine <= largest) continue;
    largest = cosine;
    best = k;
  }
  return best;
}

}  // namespace

std::vector<Ordinate> uniformSky(int count) {
  std::vector<Ordinate> sky;
  const auto share = static_cast<float>(4.0 / count);
  for (const glm::dvec3& direction : ordinateDirections(count)) sky.push_back({direction, {share}});
  return sky;
}

std::vector<Ordinate> bandedSky(int count, glm::dmat3 axesFromWorld) {
  std::vector<Ordinate> sky;
  const double share = 4.0 / count;
  for (const glm::dvec3& direction : ordinateDirections(count)) {
    const double height = glm::dot(axesFromWorld[2], direction);
    const auto part = [share](double value) { return static_cast<float>(share * std::max(value, 0.0)); };
    sky.push_back({direction, {part(height), part(1 - std::abs(height)), part(-height)}});
  }
  return sky;
}

std::vector<Ordinate> octantSky(int count, const std::array<float, kOctantCount>& intensities) {
  // A map of one texel for each octant: quarter turns from -y towards -x, above and below.
  constexpr glm::ivec2 kQuarters[] = {{-1, -1}, {-1, 1}, {1, 1}, {1, -1}};
  std::vector<glm::vec3> radiance;
  for (const int z : {1, -1})
    for (const glm::ivec2 quarter : kQuarters)
      for (std::size_t s = 0; s < intensities.size(); ++s)
        if (kOctants[s].towardsLight() == glm::ivec3(quarter, z)) radiance.emplace_back(intensities[s]);
  return mappedSky(count, {4, 2}, radiance, 0, glm::dmat3(1));
}

std::vector<Ordinate> mappedSky(int count, glm::ivec2 size, const std::vector<glm::vec3>& radiance,
                                double rotationDegrees, glm::dmat3 axesFromWorld) {
  const std::vector<glm::dvec3> directions = ordinateDirections(count);
  const glm::ivec2 parts = (kBlocks + size - 1) / size, cells = size * parts;
  const double rotation = glm::radians(rotationDegrees);
  const auto columns = static_cast<std::size_t>(kBlocks.x), rows = static_cast<std::size_t>(kBlocks.y);
  std::vector<LightVector> light(columns * rows);
  std::vector<std::size_t> owner(light.size());
  parallelFor(rows, [&](std::size_t j) {
    const auto firstOf = [](std::size_t block, int all, int blocks) {
      return static_cast<int>(static_cast<std::int64_t>(block) * all / blocks);
    };
    for (std::size_t i = 0; i < columns; ++i) {
      LightVector& sum = light[j * columns + i];
      glm::dvec3 middle(0);
      for (int y = firstOf(j, cells.y, kBlocks.y); y < firstOf(j + 1, cells.y, kBlocks.y); ++y)
        for (int x = firstOf(i, cells.x, kBlocks.x); x < firstOf(i + 1, cells.x, kBlocks.x); ++x) {
          const auto angle = [&](int edge) { return 2 * pi * (static_cast<double>(edge) / cells.x - 0.5) - rotation; };
          const glm::dvec3 part =
              axesFromWorld * directionIntegral(angle(x), angle(x + 1), pi * y / cells.y, pi * (y + 1) / cells.y);
          const glm::dvec3 color(radiance[static_cast<std::size_t>(y / parts.y) * static_cast<std::size_t>(size.x) +
                                          static_cast<std::size_t>(x / parts.x)]);
          middle += part;
          for (int c = 0; c < 3; ++c) sum[static_cast<std::size_t>(c)] += color[c] * part;
        }
      const bool black = sum == LightVector{};
      owner[j * columns + i] = black ? 0 : closest(directions, glm::normalize(middle));
    }
  });
  std::vector<LightVector> shares(directions.size());
  for (std::size_t b = 0; b < light.size(); ++b)
    for (std::size_t c = 0; c < 3; ++c) shares[owner[b]][c] += light[b][c];
  std::vector<Ordinate> sky;
  for (const LightVector& share : shares) {
    const glm::dvec3 whole = kLuminance.r * share[0] + kLuminance.g * share[1] + kLuminance.b * share[2];
    const double length = glm::length(whole);
    if (!(length > 0)) continue;  // black
    Ordinate ordinate{whole / length, {}};
    for (std::size_t c = 0; c < 3; ++c)
      ordinate.value[c] = static_cast<float>(std::max(glm::dot(share[c], ordinate.direction), 0.0) / pi);
    sky.push_back(ordinate);
  }
  return sky;
}

}  // namespace isolume
