#include "support/plain_closest.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <utility>

#include "sweep/closest/surface_band.h"

namespace isolume::test {
namespace {

using Plane = std::vector<glm::vec3>;

struct Passes {
  glm::ivec3 n;
  glm::vec3 h;
  std::vector<glm::vec3> offset;
  std::vector<std::pair<std::size_t, glm::vec3>> fixed;  // by index

  std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * n.y + y) * static_cast<std::size_t>(n.x) + x;
  }
  static void keepNearer(glm::vec3 candidate, glm::vec3& own) {
    if (squaredLength(candidate) < squaredLength(own)) own = candidate;
  }
  void takeThree(const glm::vec3* row, int x, glm::vec3 step, glm::vec3& own) const {
    for (int dx = -1; dx <= 1; ++dx)
      if (x + dx >= 0 && x + dx < n.x)
        keepNearer(row[x + dx] + glm::vec3(static_cast<float>(dx) * h.x, step.y, step.z), own);
  }
  void inPlane(int z) {
    const std::size_t perPlane = static_cast<std::size_t>(n.x) * n.y;
    glm::vec3* rising = offset.data() + index(0, 0, z);
    Plane falling(rising, rising + perPlane);
    for (int y = 1; y < n.y; ++y)
      for (int x = 0; x < n.x; ++x) takeThree(rising + (y - 1) * n.x, x, {0, -h.y, 0}, rising[y * n.x + x]);
    for (int y = n.y - 2; y >= 0; --y)
      for (int x = 0; x < n.x; ++x)
        takeThree(falling.data() + (y + 1) * n.x, x, {0, h.y, 0}, falling[static_cast<std::size_t>(y * n.x + x)]);
    for (std::size_t i = 0; i < perPlane; ++i) keepNearer(falling[i], rising[i]);
    for (int y = 0; y < n.y; ++y) {
      glm::vec3* row = rising + y * n.x;
      for (int x = 1; x < n.x; ++x) keepNearer(row[x - 1] + glm::vec3(-h.x, 0, 0), row[x]);
      for (int x = n.x - 2; x >= 0; --x) keepNearer(row[x + 1] + glm::vec3(h.x, 0, 0), row[x]);
    }
  }
  void pass(int dz) {
    for (int i = 0; i < n.z; ++i) {
      const int z = dz > 0 ? i : n.z - 1 - i;
      for (int y = 0; i > 0 && y < n.y; ++y)
        for (int x = 0; x < n.x; ++x)
          for (int dy = -1; dy <= 1; ++dy)
            if (y + dy >= 0 && y + dy < n.y)
              takeThree(&offset[index(0, y + dy, z - dz)], x, glm::vec3(0, dy, -dz) * h, offset[index(x, y, z)]);
      inPlane(z);
      for (const auto& [at, point] : fixed)
        if (at >= index(0, 0, z) && at < index(0, 0, z + 1)) offset[at] = point;
    }
  }
};

}  // namespace

std::vector<float> plainClosestDistance(GridView<const float> level, int bandVoxels, int rounds) {
  OffsetField field(level);
  const BitGrid band = solveBand(level, bandVoxels, field);
  const double unit = smallestSpacing(level.spacing);
  Passes passes{level.size, glm::vec3(level.spacing / unit), {}, {}};
  for (int z = 0; z < level.size.z; ++z)
    for (int y = 0; y < level.size.y; ++y)
      for (int x = 0; x < level.size.x; ++x) {
        const std::size_t i = level.index(x, y, z);
        const bool isFixed = band.test(x, y, z);
        passes.offset.push_back(isFixed ? field.at(i) : glm::vec3(kUnsetOffset, 0, 0));
        if (isFixed) passes.fixed.emplace_back(i, field.at(i));
      }
  const bool hasSurface = !passes.fixed.empty();
  for (int round = 0; hasSurface && round < rounds; ++round) {
    passes.pass(1);
    passes.pass(-1);
  }
  std::vector<float> distance;
  for (std::size_t i = 0; i < level.count(); ++i) {
    const float length = std::sqrt(squaredLength(passes.offset[i])) * static_cast<float>(unit);
    const float reached = hasSurface ? length : std::numeric_limits<float>::infinity();
    distance.push_back(level.data[i] > 0 ? -reached : reached);
  }
  return distance;
}

namespace {

// Corners of a mixed cell whose level is 0, to the solver's tolerance of the largest: the zero set holds them.
template <class Strew>
void strewZeroCorners(GridView<const float> level, glm::ivec3 cell, const Strew& strew) {
  constexpr double kZero = 1e-6;
  double largest = 0;
  int inside = 0;
  const auto corner = [&](int i) { return glm::min(cell + glm::ivec3(i & 1, i >> 1 & 1, i >> 2), level.size - 1); };
  for (int i = 0; i < 8; ++i) {
    const double value = level(corner(i).x, corner(i).y, corner(i).z);
    largest = std::max(largest, std::abs(value));
    inside += value > 0 ? 1 : 0;
  }
  if (inside == 0 || inside == 8) return;
  for (int i = 0; i < 8; ++i)
    if (std::abs(level(corner(i).x, corner(i).y, corner(i).z)) <= kZero * largest) strew(glm::dvec3(corner(i)));
}

}  // namespace

std::vector<double> strewnDistance(GridView<const float> level, int perAxis, bool zeroCorners) {
  const glm::ivec3 n = level.size;
  const glm::ivec3 cells = glm::max(n - 1, glm::ivec3(1));  // flat ones along an axis of one sample
  std::vector<double> nearest(level.count(), std::numeric_limits<double>::infinity());
  const auto strew = [&](glm::dvec3 p) {
    std::size_t i = 0;
    for (int z = 0; z < n.z; ++z)
      for (int y = 0; y < n.y; ++y)
        for (int x = 0; x < n.x; ++x, ++i)
          nearest[i] = std::min(nearest[i], glm::length((glm::dvec3(x, y, z) - p) * level.spacing));
  };
  for (int z = 0; z < n.z; ++z)
    for (int y = 0; y < n.y; ++y)
      for (int x = 0; x < n.x; ++x) {
        const bool border = x == 0 || y == 0 || z == 0 || x == n.x - 1 || y == n.y - 1 || z == n.z - 1;
        if (border && level(x, y, z) > 0) strew(glm::dvec3(x, y, z));
        if (x >= cells.x || y >= cells.y || z >= cells.z) continue;
        if (zeroCorners) strewZeroCorners(level, {x, y, z}, strew);
        for (int axis = 0; axis < 3; ++axis) {
          if (n[axis] == 1) continue;
          for (int j = 0; j <= perAxis; ++j)
            for (int k = 0; k <= perAxis; ++k) {
              const int b = (axis + 1) % 3, c = (axis + 2) % 3;
              const double u = static_cast<double>(j) / perAxis, v = static_cast<double>(k) / perAxis;
              const auto onFace = [&](int along) {
                double sum = 0;
                for (int corner = 0; corner < 4; ++corner) {
                  glm::ivec3 q(x, y, z);
                  q[axis] += along;
                  if (n[b] > 1) q[b] += corner & 1;
                  if (n[c] > 1) q[c] += corner >> 1;
                  sum += (corner & 1 ? u : 1 - u) * (corner >> 1 ? v : 1 - v) * level(q.x, q.y, q.z);
                }
                return sum;
              };
              const double low = onFace(0), high = onFace(1);
              if ((low > 0) == (high > 0)) continue;
              glm::dvec3 p(x, y, z);
              p[axis] += low / (low - high);
              if (n[b] > 1) p[b] += u;
              if (n[c] > 1) p[c] += v;
              strew(p);
            }
        }
      }
  return nearest;
}

bool liesOnSurface(GridView<const float> level, glm::dvec3 position, double tolerance) {
  const glm::ivec3 sample(glm::round(position));
  bool border = false;
  for (int axis = 0; axis < 3; ++axis) border |= sample[axis] == 0 || sample[axis] == level.size[axis] - 1;
  const bool atSample = glm::length(position - glm::dvec3(sample)) <= tolerance;
  if (border && atSample && level(sample.x, sample.y, sample.z) > 0) return true;
  // A point on the face of a cell belongs to both its cells.
  for (int side = 0; side < 8; ++side) {
    const glm::dvec3 nudge = tolerance * glm::dvec3(side & 1 ? 1 : -1, side & 2 ? 1 : -1, side & 4 ? 1 : -1);
    const glm::ivec3 cell =
        glm::clamp(glm::ivec3(glm::floor(position + nudge)), glm::ivec3(0), glm::max(level.size - 2, glm::ivec3(0)));
    double value = 0, largest = 0;
    int inside = 0;
    for (int corner = 0; corner < 8; ++corner) {
      const glm::ivec3 at(corner & 1, corner >> 1 & 1, corner >> 2);
      const glm::ivec3 q = glm::min(cell + at, level.size - 1);
      const glm::dvec3 t = position - glm::dvec3(cell);
      const glm::dvec3 weight = glm::dvec3(at) * t + glm::dvec3(1 - at) * (1.0 - t);
      const double corners = level(q.x, q.y, q.z);
      value += weight.x * weight.y * weight.z * corners;
      largest = std::max(largest, std::abs(corners));
      inside += corners > 0 ? 1 : 0;
    }
    if (inside > 0 && inside < 8 && std::abs(value) <= tolerance * largest) return true;
  }
  return false;
}

}  // namespace isolume::test
