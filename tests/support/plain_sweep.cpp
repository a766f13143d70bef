#include "support/plain_sweep.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "support/plain_start.h"

namespace isolume::test {
namespace {

constexpr float kUnset = 0x1p60F;
constexpr float kSmallest = 1e-30F;

// The library marks fixed values in the last bit of the mantissa; so must an equal result.
float withLastBit(float value, bool set) {
  const auto bits = std::bit_cast<std::uint32_t>(value);
  return std::bit_cast<float>(set ? bits | 1U : bits & ~1U);
}

struct State {
  GridView<const float> level;
  glm::vec3 h;
  std::vector<float> magnitude;
  std::vector<bool> fixed;
};

void start(State& state, DistanceStart kind) {
  const glm::ivec3 n = state.level.size;
  for (int z = 0; z < n.z; ++z)
    for (int y = 0; y < n.y; ++y)
      for (int x = 0; x < n.x; ++x) {
        float best = kUnset;
        const float here = state.level(x, y, z);
        for (int axis = 0; axis < 3; ++axis)
          for (int step : {-1, 1}) {
            glm::ivec3 q(x, y, z);
            q[axis] += step;
            if (q[axis] < 0 || q[axis] >= n[axis]) {
              if (here > 0) best = 0;
              continue;
            }
            const float there = state.level(q.x, q.y, q.z);
            if ((here > 0) != (there > 0))
              best = std::min(best, state.h[axis] * ((0.5F * here) / (0.5F * here - 0.5F * there)));
          }
        const std::size_t i = state.level.index(x, y, z);
        state.fixed[i] = best < kUnset;
        best = std::max(best, kSmallest);
        if (state.fixed[i] && kind == DistanceStart::better)
          best = plainBetterStart(state.level, state.h, {x, y, z}, withLastBit(best, true));
        state.magnitude[i] = withLastBit(best, state.fixed[i]);
      }
}

}  // namespace

namespace {

// Root of sum over the nearest `count` neighbours of ((d - a_i) / h_i)^2 = 1 in double.
double rootOver(int count, const std::array<int, 3>& axis, glm::vec3 a, glm::dvec3 h) {
  const double nearest = a[axis[0]];
  double w = 0, linear = 0, square = -1;
  for (int i = 0; i < count; ++i) {
    const int k = axis[static_cast<std::size_t>(i)];
    const double weight = 1 / (h[k] * h[k]);
    w += weight;
    linear += weight * (a[k] - nearest);
    square += weight * (a[k] - nearest) * (a[k] - nearest);
  }
  return nearest + (linear + std::sqrt(linear * linear - w * square)) / w;
}

}  // namespace

float plainUpdate(glm::vec3 neighbours, glm::dvec3 spacing) {
  std::array<int, 3> axis{0, 1, 2};
  std::stable_sort(axis.begin(), axis.end(), [&](int a, int b) { return neighbours[a] < neighbours[b]; });
  double root = rootOver(1, axis, neighbours, spacing);
  for (int count = 2; count <= 3 && root > neighbours[axis[static_cast<std::size_t>(count) - 1]]; ++count)
    root = rootOver(count, axis, neighbours, spacing);
  // The smallest even float with sum max(0, (d - a_i) / h_i)^2 >= 1.
  const glm::vec3 weight(1.0 / (spacing * spacing));
  const auto reaches = [&](std::uint32_t bits) {
    glm::vec3 term;
    for (int k = 0; k < 3; ++k) {
      const float x = std::max(std::bit_cast<float>(bits) - neighbours[k], 0.0F);
      term[k] = weight[k] * (x * x);
    }
    return sortedSum(term.x, term.y, term.z) >= 1;
  };
  std::uint32_t bits = std::bit_cast<std::uint32_t>(static_cast<float>(root)) & ~1U;
  while (reaches(bits)) bits -= 2;
  while (!reaches(bits)) bits += 2;
  return std::bit_cast<float>(bits);
}

std::vector<float> plainSweep(GridView<const float> level, int rounds, DistanceStart kind) {
  const glm::ivec3 n = level.size;
  const double smallest = smallestSpacing(level.spacing);
  const glm::dvec3 h = level.spacing / smallest;
  State state{level, glm::vec3(h), std::vector<float>(level.count()), std::vector<bool>(level.count())};
  start(state, kind);

  for (int round = 0; round < rounds; ++round)
    for (int s = 0; s < kOctantCount; ++s) {
      const glm::ivec3 sign = kOctants[static_cast<std::size_t>(s)].sweep;
      for (int k = 0; k < n.z; ++k)
        for (int j = 0; j < n.y; ++j)
          for (int i = 0; i < n.x; ++i) {
            const glm::ivec3 p(sign.x > 0 ? i : n.x - 1 - i, sign.y > 0 ? j : n.y - 1 - j,
                               sign.z > 0 ? k : n.z - 1 - k);
            const std::size_t at = level.index(p.x, p.y, p.z);
            glm::vec3 distance(kUnset);
            for (int axis = 0; axis < 3; ++axis) {
              glm::ivec3 q = p;
              q[axis] -= sign[axis];
              if (q[axis] < 0 || q[axis] >= n[axis]) continue;
              distance[axis] = state.magnitude[level.index(q.x, q.y, q.z)];
            }
            float& magnitude = state.magnitude[at];
            const glm::vec3 beyond = distance + state.h;
            const float nearest = std::min({beyond.x, beyond.y, beyond.z});
            magnitude = state.fixed[at] ? std::min(magnitude, withLastBit(nearest, true))
                                        : std::min(magnitude, plainUpdate(distance, h));
          }
    }

  std::vector<float> field(level.count());
  for (std::size_t i = 0; i < level.count(); ++i) {
    const float magnitude = withLastBit(state.magnitude[i], false);
    const float world =
        magnitude < kUnset ? magnitude * static_cast<float>(smallest) : std::numeric_limits<float>::infinity();
    field[i] = level.data[i] > 0 ? -world : world;
  }
  return field;
}

}  // namespace isolume::test
