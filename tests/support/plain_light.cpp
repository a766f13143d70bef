#include "support/plain_light.h"

#include <algorithm>
#include <cmath>

#include "sweep/godunov/surface_start.h"

namespace isolume::test {
namespace {

// Calls visit(index, p, neighbour) for every sample p in the order of the sweep; neighbour(axis) is the sample's index
// upwind, or -1 outside.
template <class Visit>
void forEachInOrder(GridView<const float> grid, glm::ivec3 sign, const Visit& visit) {
  const glm::ivec3 n = grid.size;
  for (int k = 0; k < n.z; ++k)
    for (int j = 0; j < n.y; ++j)
      for (int i = 0; i < n.x; ++i) {
        const glm::ivec3 p(sign.x > 0 ? i : n.x - 1 - i, sign.y > 0 ? j : n.y - 1 - j, sign.z > 0 ? k : n.z - 1 - k);
        visit(grid.index(p.x, p.y, p.z), p, [&](int axis) -> std::ptrdiff_t {
          glm::ivec3 q = p;
          q[axis] -= sign[axis];
          if (q[axis] < 0 || q[axis] >= n[axis]) return -1;
          return static_cast<std::ptrdiff_t>(grid.index(q.x, q.y, q.z));
        });
      }
}

// Product of two numbers in units of 2^-15, to nearest, ties up.
int product(int a, int b) { return (a * b + (1 << 14)) >> 15; }

}  // namespace

float plainTransmittance(float distance, float opacity) {
  if (opacity == 1) return std::min(std::max(distance + 0.5F, 0.0F), 1.0F);
  return std::min(std::max(opacity * distance + (1 - opacity / 2), 1 - opacity), 1.0F);
}

std::vector<float> plainLight(GridView<const float> distance, glm::ivec3 sign, float opacity) {
  const double smallest = smallestSpacing(distance.spacing);
  const glm::dvec3 h = distance.spacing / smallest;
  const double inverseSum = 1 / h.x + 1 / h.y + 1 / h.z;
  glm::vec3 weight(1 / h.x / inverseSum, 1 / h.y / inverseSum, 0);
  weight.z = 1.0F - (weight.x + weight.y);
  const float perSmallest = 1 / static_cast<float>(smallest);
  constexpr float kDarkest = 1e-20F;
  std::vector<float> visibility(distance.count());
  forEachInOrder(distance, sign, [&](std::size_t at, glm::ivec3, const auto& upwind) {
    glm::vec3 light(1);
    for (int axis = 0; axis < 3; ++axis) {
      const std::ptrdiff_t from = upwind(axis);
      if (from < 0) continue;
      const float given = distance.data[from];
      // A start value: its last bit is set (surface_start.h).
      const float magnitude = withFixedBit(std::min(std::abs(given) * perSmallest, 2.0F), true);
      light[axis] =
          visibility[static_cast<std::size_t>(from)] * plainTransmittance(std::copysign(magnitude, given), opacity);
    }
    const float sum = (weight.x * light.x + weight.y * light.y) + weight.z * light.z;
    visibility[at] = sum >= kDarkest ? sum : 0;
  });
  return visibility;
}

std::vector<std::int16_t> plainFixedLight(GridView<const float> distance, glm::ivec3 sign, float opacity) {
  constexpr int kOne = 32768, kFull = 32767;
  const glm::dvec3 inverse = 1.0 / distance.spacing;
  const double sum = inverse.x + inverse.y + inverse.z;
  const auto weightOf = [&](double part) { return std::min(static_cast<int>(std::lround(kOne * part / sum)), kFull); };
  const int weightX = weightOf(inverse.x), weightY = weightOf(inverse.y);
  const float perSmallest = 1 / static_cast<float>(smallestSpacing(distance.spacing));
  std::vector<std::int16_t> visibility(distance.count());
  forEachInOrder(distance, sign, [&](std::size_t at, glm::ivec3 p, const auto& upwind) {
    glm::ivec3 leaving(-kFull);
    for (int axis = 0; axis < 3; ++axis) {
      const std::ptrdiff_t from = upwind(axis);
      if (from < 0) continue;
      const float near = std::min(std::max(distance.data[from] * perSmallest, -1.0F), 1.0F);
      const float tau = std::min(std::max(opacity * near + (1 - opacity / 2), 1 - opacity), 1.0F);
      const int minusTau = static_cast<int>(std::nearbyint(tau * -static_cast<float>(kOne)));
      leaving[axis] = product(visibility[static_cast<std::size_t>(from)], minusTau);
    }
    const int turn = ((sign.x * p.x + sign.y * p.y + sign.z * p.z) % 3 + 3) % 3;
    const int dither = weightX >= kOne / 2 || weightY >= kOne / 2 || turn == 0 ? 0 : turn == 1 ? 1 : -1;
    const int z = leaving.z + dither;
    const int light = product(std::min(leaving.x - z, kFull), -weightX) - leaving.z +
                      product(std::min(leaving.y - z, kFull), -weightY);
    visibility[at] = static_cast<std::int16_t>(std::clamp(light, 0, kFull));
  });
  return visibility;
}

}  // namespace isolume::test
