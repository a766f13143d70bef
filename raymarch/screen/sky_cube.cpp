#include "raymarch/screen/sky_cube.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec4.hpp>
#include <numbers>

#include "sweep/parallel.h"

namespace isolume {
namespace {

using std::numbers::pi;

/// Parts of a map along each axis, at least: .35 degrees, finer than the least texel of a cube of kSkySide, .6 degrees.
constexpr glm::ivec2 kLeastParts{1024, 512};
/// Bands of rows of a map that are summed apart and added in order: the same bits for any number of threads.
constexpr int kBands = 16;

/// [OpenGL 4.5] Table 8.19.
glm::dvec3 facePoint(int face, double s, double t) {
  switch (face) {
    case 0:
      return {1, -t, -s};
    case 1:
      return {-1, -t, s};
    case 2:
      return {s, 1, t};
    case 3:
      return {s, -1, -t};
    case 4:
      return {s, -t, 1};
    default:
      return {-s, -t, -1};
  }
}

/// Of the face at z = 1, from its centre to (x, y).
double solidAngleTo(double x, double y) { return std::atan2(x * y, std::sqrt(x * x + y * y + 1)); }

/// w: solid angle.
using Light = std::vector<glm::dvec4>;

}  // namespace

glm::dvec3 cubeDirection(int side, int face, glm::dvec2 at) {
  return glm::normalize(facePoint(face, 2 * at.x / side - 1, 2 * at.y / side - 1));
}

glm::dvec3 cubeTexelDirection(int side, std::size_t texel) {
  const auto edge = static_cast<std::size_t>(side), face = edge * edge;
  const glm::dvec2 at(static_cast<double>(texel % edge), static_cast<double>(texel % face / edge));
  return cubeDirection(side, static_cast<int>(texel / face), at + 0.5);
}

std::size_t cubeTexel(int side, glm::dvec3 direction) {
  const glm::dvec3 size = glm::abs(direction);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const int face = 2 * axis + (direction[axis] < 0 ? 1 : 0);
  const glm::dvec3 p = direction / size[axis], sAxis = facePoint(face, 1, 0) - facePoint(face, 0, 0),
                   tAxis = facePoint(face, 0, 1) - facePoint(face, 0, 0);
  const auto texel = [side](double coordinate) {
    return static_cast<std::size_t>(std::clamp(static_cast<int>((coordinate + 1) / 2 * side), 0, side - 1));
  };
  const auto edge = static_cast<std::size_t>(side);
  return (static_cast<std::size_t>(face) * edge + texel(glm::dot(p, tAxis))) * edge + texel(glm::dot(p, sAxis));
}

std::vector<double> cubeSolidAngles(int side) {
  std::vector<double> angles;
  const auto edge = [side](int i) { return 2.0 * i / side - 1; };
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i)
      angles.push_back(solidAngleTo(edge(i + 1), edge(j + 1)) - solidAngleTo(edge(i), edge(j + 1)) -
                       solidAngleTo(edge(i + 1), edge(j)) + solidAngleTo(edge(i), edge(j)));
  return angles;
}

void addEvenSky(SkyCube& sky, glm::vec3 radiance) {
  for (glm::vec3& texel : sky.radiance) texel += radiance;
}

void addBandedSky(SkyCube& sky, glm::vec3 zenith, glm::vec3 horizon, glm::vec3 ground, glm::dmat3 worldFromAxes) {
  const glm::dvec3 up = glm::transpose(worldFromAxes)[2];
  for (std::size_t i = 0; i < sky.radiance.size(); ++i) {
    const auto height = static_cast<float>(glm::dot(up, cubeTexelDirection(sky.side, i)));
    sky.radiance[i] +=
        std::max(height, 0.0F) * zenith + (1 - std::abs(height)) * horizon + std::max(-height, 0.0F) * ground;
  }
}

void addMappedSky(SkyCube& sky, glm::ivec2 size, const std::vector<glm::vec3>& radiance, double rotationDegrees,
                  float scale, glm::dmat3 worldFromAxes) {
  assert(sky.side == kSkySide && size.x > 0 && size.y > 0);
  const glm::ivec2 parts = (kLeastParts + size - 1) / size, cells = size * parts;
  const double rotation = glm::radians(rotationDegrees);
  const glm::dmat3 axesFromWorld = glm::transpose(worldFromAxes);
  std::vector<glm::dvec2> turns(static_cast<std::size_t>(cells.x));  // x, y of a column on the horizon
  for (int x = 0; x < cells.x; ++x) {
    const double angle = 2 * pi * ((x + 0.5) / cells.x - 0.5) - rotation;
    turns[static_cast<std::size_t>(x)] = {std::sin(angle), std::cos(angle)};
  }
  std::vector<Light> bands(kBands, Light(sky.radiance.size(), glm::dvec4(0)));
  parallelFor(bands.size(), [&](std::size_t band) {
    const auto first = static_cast<int>(band * static_cast<std::size_t>(cells.y) / kBands),
               last = static_cast<int>((band + 1) * static_cast<std::size_t>(cells.y) / kBands);
    for (int y = first; y < last; ++y) {
      const double fall = pi * (y + 0.5) / cells.y;
      const double angle = 2 * pi / cells.x * (std::cos(pi * y / cells.y) - std::cos(pi * (y + 1) / cells.y));
      const glm::vec3* row = &radiance[static_cast<std::size_t>(y / parts.y) * static_cast<std::size_t>(size.x)];
      for (int x = 0; x < cells.x; ++x) {
        const glm::dvec3 direction(std::sin(fall) * turns[static_cast<std::size_t>(x)], std::cos(fall));
        bands[band][cubeTexel(sky.side, axesFromWorld * direction)] += angle * glm::dvec4(row[x / parts.x], 1);
      }
    }
  });
  for (std::size_t i = 0; i < sky.radiance.size(); ++i) {
    glm::dvec4 sum(0);
    for (const Light& band : bands) sum += band[i];
    assert(sum.w > 0);
    sky.radiance[i] += scale * glm::vec3(glm::dvec3(sum) / sum.w);
  }
}

SkyCube halvedSky(const SkyCube& sky) {
  assert(sky.side % 2 == 0);
  SkyCube half{sky.side / 2, {}};
  const std::vector<double> angles = cubeSolidAngles(sky.side);
  const auto edge = static_cast<std::size_t>(sky.side);
  for (std::size_t row = 0; row < kCubeFaces * edge; row += 2)
    for (std::size_t column = 0; column < edge; column += 2) {
      glm::dvec3 sum(0);
      double whole = 0;
      for (const std::size_t offset : {std::size_t{0}, std::size_t{1}, edge, edge + 1}) {
        const std::size_t texel = row * edge + column + offset;
        sum += angles[texel % angles.size()] * glm::dvec3(sky.radiance[texel]);
        whole += angles[texel % angles.size()];
      }
      half.radiance.emplace_back(sum / whole);
    }
  return half;
}

}  // namespace isolume
