#include "clearance.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "half.h"
#include "sweep/parallel.h"

namespace isolume {
namespace shader {
using uint = unsigned int;
#include "shaders/shared/clearance_code.h"
}  // namespace shader

namespace {

constexpr float kTrusted = 0.9f;
constexpr float kMargin = 1.5f;

float smallest(glm::dvec3 v) { return static_cast<float>(std::min({v.x, v.y, v.z})); }
float largest(glm::dvec3 v) { return static_cast<float>(std::max({v.x, v.y, v.z})); }

// One row of cells from the four rows of samples about it.
struct RowClearance {
  float toUnits;  // |distance| summed over eight corners to units of kClearanceUnit, trusted part
  float marginUnits;

  void operator()(const float* const level[4], const float* const distance[4], int cells, std::uint8_t* out) const {
    const float* l0 = level[0];
    const float* l1 = level[1];
    const float* l2 = level[2];
    const float* l3 = level[3];
    const float* d0 = distance[0];
    const float* d1 = distance[1];
    const float* d2 = distance[2];
    const float* d3 = distance[3];
    for (int x = 0; x < cells; ++x) {
      const int inside = (l0[x] > 0) + (l1[x] > 0) + (l2[x] > 0) + (l3[x] > 0) + (l0[x + 1] > 0) + (l1[x + 1] > 0) +
                         (l2[x + 1] > 0) + (l3[x + 1] > 0);
      const float sum = ((std::abs(d0[x]) + std::abs(d1[x])) + (std::abs(d2[x]) + std::abs(d3[x]))) +
                        ((std::abs(d0[x + 1]) + std::abs(d1[x + 1])) + (std::abs(d2[x + 1]) + std::abs(d3[x + 1])));
      const float units = sum * toUnits - marginUnits;
      // Written so that a NaN gives 0.
      const float radius =
          units > 0 ? (units < shader::kClearanceRadiusMask - 1 ? units : shader::kClearanceRadiusMask - 1) : 0;
      const int code = 1 + static_cast<int>(radius);
      const int sided = code | (inside == 8 ? static_cast<int>(shader::kClearanceInside) : 0);
      const bool mixed = inside != 0 && inside != 8;
      out[x] = static_cast<std::uint8_t>(mixed ? 0 : sided);
    }
  }
};

}  // namespace

std::vector<std::uint8_t> buildClearance(GridView<const float> level, GridView<const float> distance) {
  assert(level.size == distance.size);
  const glm::ivec3 cells = level.size - 1;
  std::vector<std::uint8_t> out(voxelCount(cells));
  const float unit = shader::kClearanceUnit * smallest(level.spacing);
  const RowClearance row{kTrusted / (8 * unit), kMargin * largest(level.spacing) / unit};
  parallelFor(static_cast<std::size_t>(cells.z), [&](std::size_t z) {
    for (int y = 0; y < cells.y; ++y) {
      const float* levelRows[4];
      const float* distanceRows[4];
      for (int corner = 0; corner < 4; ++corner) {
        const std::size_t start = level.index(0, y + (corner & 1), static_cast<int>(z) + corner / 2);
        levelRows[corner] = level.data + start;
        distanceRows[corner] = distance.data + start;
      }
      row(levelRows, distanceRows, cells.x, out.data() + (z * cells.y + static_cast<std::size_t>(y)) * cells.x);
    }
  });
  return out;
}

std::vector<std::uint16_t> packDistance(GridView<const float> distance) {
  std::vector<std::uint16_t> out(distance.count());
  const float toUnits = 1 / smallest(distance.spacing);
  const auto plane = static_cast<std::size_t>(distance.strideZ());
  parallelFor(static_cast<std::size_t>(distance.size.z), [&](std::size_t z) {
    const float* from = distance.data + z * plane;
    std::uint16_t* to = out.data() + z * plane;
    for (std::size_t i = 0; i < plane; ++i) to[i] = halfFromFloat(from[i] * toUnits);
  });
  return out;
}

}  // namespace isolume
