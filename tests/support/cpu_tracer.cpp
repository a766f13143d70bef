#include "support/cpu_tracer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <vector>

namespace isolume::test {
namespace {

using Bernstein = std::array<double, 4>;

// First t in [low, high] where the polynomial with these Bernstein coefficients over that range is above 0.
std::optional<double> firstPositive(const Bernstein& b, double low, double high, int depth) {
  if (b[0] > 0) return low;
  if (std::max({b[1], b[2], b[3]}) <= 0) return std::nullopt;
  // 2^-45 of a cell is near the end of double.
  constexpr int kDepth = 45;
  if (depth == kDepth) return low;
  const double ab = (b[0] + b[1]) / 2, bc = (b[1] + b[2]) / 2, cd = (b[2] + b[3]) / 2;
  const double abc = (ab + bc) / 2, bcd = (bc + cd) / 2, middle = (abc + bcd) / 2, t = (low + high) / 2;
  if (const auto root = firstPositive({b[0], ab, abc, middle}, low, t, depth + 1)) return root;
  return firstPositive({middle, bcd, cd, b[3]}, t, high, depth + 1);
}

// The interpolant of one cell, also beyond its faces.
double cellAt(GridView<const float> level, glm::ivec3 cell, glm::dvec3 p) {
  const glm::dvec3 u = p - glm::dvec3(cell);
  double sum = 0;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 bit(corner & 1, (corner >> 1) & 1, corner >> 2);
    const double weight = (bit.x ? u.x : 1 - u.x) * (bit.y ? u.y : 1 - u.y) * (bit.z ? u.z : 1 - u.z);
    sum += weight * level(cell.x + bit.x, cell.y + bit.y, cell.z + bit.z);
  }
  return sum;
}

glm::ivec3 cellOf(GridView<const float> level, glm::dvec3 p) {
  return glm::clamp(glm::ivec3(glm::floor(p)), glm::ivec3(0), level.size - 2);
}

}  // namespace

IndexRay pixelRay(const Camera& camera, glm::ivec2 imageSize, glm::dvec2 pixel, const glm::dmat4& worldFromGrid) {
  const CameraAxes axes = cameraAxes(camera);
  const double x = (2 * pixel.x - imageSize.x) / imageSize.y, y = (imageSize.y - 2 * pixel.y) / imageSize.y;
  const glm::dmat4 gridFromWorld = glm::inverse(worldFromGrid);
  glm::dvec3 origin = camera.eye, direction = axes.forward;
  if (camera.projection == Projection::perspective) {
    const double half = std::tan(glm::radians(camera.fovDegrees) / 2) / camera.zoom;
    direction += half * (x * axes.right + y * axes.up);
  } else {
    origin += camera.heightWorld / 2 / camera.zoom * (x * axes.right + y * axes.up);
  }
  return {glm::dvec3(gridFromWorld * glm::dvec4(origin, 1)), glm::dvec3(gridFromWorld * glm::dvec4(direction, 0))};
}

std::optional<TracedHit> traceLevel(GridView<const float> level, const IndexRay& ray) {
  const glm::dvec3 high(level.size - 1);
  double begin = 0, end = std::numeric_limits<double>::infinity();
  int faceAxis = -1;
  for (int axis = 0; axis < 3; ++axis) {
    if (ray.direction[axis] == 0) {
      if (ray.origin[axis] < 0 || ray.origin[axis] > high[axis]) return std::nullopt;
      continue;
    }
    const double t0 = -ray.origin[axis] / ray.direction[axis];
    const double t1 = (high[axis] - ray.origin[axis]) / ray.direction[axis];
    if (std::min(t0, t1) > begin) faceAxis = axis;
    begin = std::max(begin, std::min(t0, t1));
    end = std::min(end, std::max(t0, t1));
  }
  if (!(begin < end)) return std::nullopt;

  const auto point = [&](double t) { return ray.origin + t * ray.direction; };
  if (levelAt(level, glm::clamp(point(begin), glm::dvec3(0), high)) > 0)
    return TracedHit{begin, point(begin), faceAxis};
  std::vector<double> cuts{begin, end};
  for (int axis = 0; axis < 3; ++axis) {
    for (int plane = 0; plane < level.size[axis] && ray.direction[axis] != 0; ++plane) {
      const double t = (plane - ray.origin[axis]) / ray.direction[axis];
      if (t > begin && t < end) cuts.push_back(t);
    }
  }
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
    const double a = cuts[i], b = cuts[i + 1];
    const glm::ivec3 cell = cellOf(level, point((a + b) / 2));
    const auto value = [&](double share) { return cellAt(level, cell, point(a + share * (b - a))); };
    // Bernstein coefficients of the cubic through four equidistant samples.
    const double f0 = value(0), f1 = value(1.0 / 3), f2 = value(2.0 / 3), f3 = value(1);
    const Bernstein bernstein{f0, (-5 * f0 + 18 * f1 - 9 * f2 + 2 * f3) / 6, (2 * f0 - 9 * f1 + 18 * f2 - 5 * f3) / 6,
                              f3};
    if (const auto t = firstPositive(bernstein, a, b, 0)) return TracedHit{*t, point(*t), -1};
  }
  return std::nullopt;
}

double levelAt(GridView<const float> level, glm::dvec3 position) {
  return cellAt(level, cellOf(level, position), position);
}

glm::dvec3 gradientAt(GridView<const float> level, glm::dvec3 position) {
  glm::dvec3 gradient;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 before = position, after = position;
    before[axis] = std::max(0.0, position[axis] - 1);
    after[axis] = std::min(level.size[axis] - 1.0, position[axis] + 1);
    gradient[axis] =
        (levelAt(level, after) - levelAt(level, before)) / ((after[axis] - before[axis]) * level.spacing[axis]);
  }
  return gradient;
}

}  // namespace isolume::test
