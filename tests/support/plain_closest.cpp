#include "support/plain_closest.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <utility>

#include "sweep/closest/surface_band.h"

namespace isolume::test {
namespace {

struct Passes {
  glm::ivec3 n;
  glm::vec3 h;
  std::vector<std::pair<std::size_t, glm::vec3>> fixed;  // by index

  std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * n.y + y) * static_cast<std::size_t>(n.x) + x;
  }
  static void keepNearer(glm::vec3 candidate, glm::vec3& own) {
    if (squaredLength(candidate) < squaredLength(own)) own = candidate;
  }
  // Sample `at` of `offset` takes candidates from the three about its neighbour at `step`, along `axis`.
  void takeThree(const std::vector<glm::vec3>& from, glm::ivec3 at, glm::ivec3 step, int axis, glm::vec3& own) const {
    for (int d = -1; d <= 1; ++d) {
      step[axis] = d;
      const glm::ivec3 q = at + step;
      if (glm::all(glm::greaterThanEqual(q, glm::ivec3(0))) && glm::all(glm::lessThan(q, n)))
        keepNearer(from[index(q.x, q.y, q.z)] + glm::vec3(step) * h, own);
    }
  }
  // Lines of plane z take candidates from the line before, both ways along `across`; `along` is the other axis.
  void inPlane(int z, int across, int along, std::vector<glm::vec3>& offset) const {
    for (const int way : {1, -1})
      for (int i = 1; i < n[across]; ++i)
        for (int j = 0; j < n[along]; ++j) {
          glm::ivec3 at(0, 0, z), step(0);
          at[across] = way > 0 ? i : n[across] - 1 - i;
          at[along] = j;
          step[across] = -way;
          takeThree(offset, at, step, along, offset[index(at.x, at.y, at.z)]);
        }
  }
  void pass(int dz, std::vector<glm::vec3>& offset) const {
    for (int i = 0; i < n.z; ++i) {
      const int z = dz > 0 ? i : n.z - 1 - i;
      for (int y = 0; i > 0 && y < n.y; ++y)
        for (int x = 0; x < n.x; ++x)
          for (int dy = -1; dy <= 1; ++dy) takeThree(offset, {x, y, z}, {0, dy, -dz}, 0, offset[index(x, y, z)]);
      inPlane(z, 1, 0, offset);
      inPlane(z, 0, 1, offset);
      for (const auto& [at, point] : fixed)
        if (at >= index(0, 0, z) && at < index(0, 0, z + 1)) offset[at] = point;
    }
  }
  // Both passes from the same start; then the nearer point of the two.
  void round(std::vector<glm::vec3>& offset) const {
    std::vector<glm::vec3> down = offset;
    pass(1, offset);
    pass(-1, down);
    for (std::size_t i = 0; i < offset.size(); ++i) keepNearer(down[i], offset[i]);
  }
};

}  // namespace

std::vector<float> plainClosestDistance(GridView<const float> level, int bandVoxels, int rounds) {
  OffsetField field(level);
  const BitGrid band = solveBand(level, bandVoxels, field);
  const double unit = smallestSpacing(level.spacing);
  Passes passes{level.size, glm::vec3(level.spacing / unit), {}};
  std::vector<glm::vec3> offset;
  for (int z = 0; z < level.size.z; ++z)
    for (int y = 0; y < level.size.y; ++y)
      for (int x = 0; x < level.size.x; ++x) {
        const std::size_t i = level.index(x, y, z);
        const bool isFixed = band.test(x, y, z);
        offset.push_back(isFixed ? field.at(i) : glm::vec3(kUnsetOffset, 0, 0));
        if (isFixed) passes.fixed.emplace_back(i, field.at(i));
      }
  const bool hasSurface = !passes.fixed.empty();
  for (int round = 0; hasSurface && round < rounds; ++round) passes.round(offset);
  std::vector<float> distance;
  for (std::size_t i = 0; i < level.count(); ++i) {
    const float length = std::sqrt(squaredLength(offset[i])) * static_cast<float>(unit);
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
