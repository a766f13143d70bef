#include "support/plain_start.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace isolume::test {
namespace {

constexpr float kUnset = 0x1p60F;
constexpr float kSmallest = 1e-30F;
constexpr float kReach = 0.5F;
constexpr int kSteps = 2;

float sortedProduct(std::array<float, 3> v) {
  std::sort(v.begin(), v.end());
  return v[0] * v[1] * v[2];
}
float dot(glm::vec3 a, glm::vec3 b) { return sortedSum(a.x * b.x, a.y * b.y, a.z * b.z); }

// Levels at the corners of the cell in which the surface is sought.
using Corners = std::array<float, 8>;

float valueAt(const Corners& c, glm::vec3 t) {
  const glm::vec3 linear(c[1] - c[0], c[2] - c[0], c[4] - c[0]);
  const glm::vec3 mixed((c[6] + c[0]) - (c[2] + c[4]), (c[5] + c[0]) - (c[1] + c[4]), (c[3] + c[0]) - (c[1] + c[2]));
  const float all = (c[7] - c[0]) - (sortedSum(c[3], c[5], c[6]) - sortedSum(c[1], c[2], c[4]));
  const glm::vec3 pairs(t.y * t.z, t.x * t.z, t.x * t.y);
  return c[0] + (dot(linear, t) + (dot(mixed, pairs) + all * sortedProduct({t.x, t.y, t.z})));
}
glm::vec3 gradientAt(const Corners& c, glm::vec3 t, glm::vec3 h) {
  const glm::vec3 mixed((c[6] + c[0]) - (c[2] + c[4]), (c[5] + c[0]) - (c[1] + c[4]), (c[3] + c[0]) - (c[1] + c[2]));
  const float all = (c[7] - c[0]) - (sortedSum(c[3], c[5], c[6]) - sortedSum(c[1], c[2], c[4]));
  return {((c[1] - c[0]) + ((mixed.y * t.z + mixed.z * t.y) + all * (t.y * t.z))) / h.x,
          ((c[2] - c[0]) + ((mixed.x * t.z + mixed.z * t.x) + all * (t.x * t.z))) / h.y,
          ((c[4] - c[0]) + ((mixed.x * t.y + mixed.y * t.x) + all * (t.x * t.y))) / h.z};
}

}  // namespace

float sortedSum(float x, float y, float z) {
  std::array<float, 3> v{x, y, z};
  std::sort(v.begin(), v.end());
  return v[0] + v[1] + v[2];
}

float plainBetterStart(GridView<const float> level, glm::vec3 spacing, glm::ivec3 p, float axisMinimum) {
  const float here = std::abs(level(p.x, p.y, p.z));
  const bool solid = level(p.x, p.y, p.z) > 0;
  const auto at = [&](glm::ivec3 q) { return solid ? level(q.x, q.y, q.z) : -level(q.x, q.y, q.z); };
  glm::vec3 inverse(0);
  glm::ivec3 side(0);
  bool believed = true;
  for (int axis = 0; axis < 3; ++axis) {
    glm::ivec3 q = p;
    q[axis] = std::max(p[axis] - 1, 0);
    const float before = at(q);
    q[axis] = std::min(p[axis] + 1, level.size[axis] - 1);
    const float after = at(q);
    const float there = std::min(before, after);
    const bool crossed = solid ? there <= 0 : there < 0;
    inverse[axis] = 1 / (crossed ? spacing[axis] * (here / (here - there)) : kUnset);
    if (crossed && before == after) believed = false;
    const bool ridge = !crossed && before < here && after < here;
    if (before != after && !ridge && there < here) side[axis] = after < before ? 1 : -1;
  }
  inverse *= inverse;
  const float three = 1 / std::sqrt(sortedSum(inverse.x, inverse.y, inverse.z));

  Corners corners{};
  float largest = 0;
  for (int i = 0; i < 8; ++i) {
    corners[static_cast<std::size_t>(i)] = at(p + side * glm::ivec3(i & 1, i >> 1 & 1, i >> 2));
    largest = std::max(largest, std::abs(corners[static_cast<std::size_t>(i)]));
  }
  for (float& corner : corners) corner /= largest;

  glm::vec3 t(0);
  float distance = three;
  for (int step = 0; step < kSteps && believed; ++step) {
    const glm::vec3 gradient = gradientAt(corners, t, spacing);
    const float steepness = dot(gradient, gradient);
    const float plane = dot(gradient, t * spacing) - valueAt(corners, t);
    const float along = plane / steepness;
    distance = std::abs(plane) / std::sqrt(steepness);
    const glm::vec3 foot = gradient * along / spacing;
    if (!(steepness > 0)) believed = false;
    for (int axis = 0; axis < 3; ++axis) {
      if (std::isnan(foot[axis])) believed = false;
      if (step + 1 == kSteps && !(foot[axis] >= -kReach && foot[axis] <= 1 + kReach)) believed = false;
      t[axis] = std::min(std::max(foot[axis], 0.0F), 1.0F);
    }
  }
  return std::max(std::min(believed ? distance : three, axisMinimum), kSmallest);
}

}  // namespace isolume::test
