#include "closest_point.h"

#include <array>
#include <limits>

namespace isolume {
namespace {

constexpr int kTangentSteps = 4;     // contraction (distance * curvature)^4: .01 for .3, and most stop after two
constexpr int kProjections = 5;      // Newton's method doubles the digits; a linear f needs one step and one check
constexpr int kHalvings = 2;         // of a tangential step that led further away
constexpr double kSettled = 1e-4;    // a tangential step this short moves the distance by less than kOnSurface
constexpr double kLongestJump = 3;   // a projection longer than this, in smallest spacings, has lost its sheet
constexpr double kWorthTrying = .9;  // of the best distance: the tangent plane of another start must be this near

double squared(glm::dvec3 v) { return glm::dot(v, v); }

// Drops the parts of `direction` that lead out of the box at `position`.
glm::dvec3 alongBorder(const LevelInterpolant& level, glm::dvec3 position, glm::dvec3 direction) {
  for (int axis = 0; axis < 3; ++axis) {
    const bool low = position[axis] <= 0 && direction[axis] < 0;
    const bool high = position[axis] >= level.level.size[axis] - 1 && direction[axis] > 0;
    if (low || high) direction[axis] = 0;
  }
  return direction;
}

glm::dvec3 clampToBox(const LevelInterpolant& level, glm::dvec3 position) {
  return glm::clamp(position, glm::dvec3(0), glm::dvec3(level.level.size - 1));
}

// Newton onto the surface; on success `offset` lies on it.
bool project(const LevelInterpolant& level, glm::dvec3 origin, glm::dvec3& offset) {
  for (int i = 0; i < kProjections; ++i) {
    const glm::dvec3 position = clampToBox(level, origin + offset / level.step);
    offset = (position - origin) * level.step;
    const LevelAtPoint here = level.at(position);
    const double steepness = squared(here.gradient);
    if (!here.mixed || !(steepness > 0)) return false;
    if (here.value * here.value <= kOnSurface * kOnSurface * steepness) return true;
    const double sign = here.value > 0 ? -1 : 1;
    const glm::dvec3 direction = alongBorder(level, position, sign * here.gradient);
    const double slope = squared(direction);
    if (!(slope > 0)) return false;
    const glm::dvec3 move = direction * (std::abs(here.value) / slope);
    if (!(squared(move) < kLongestJump * kLongestJump)) return false;
    offset += move;
  }
  return false;
}

struct Corner {
  glm::ivec3 at{0};
  double level = 0;
};

// Nearest crossing of the edges of one cell, which lies in direction `towards` (+-1 each) of the sample.
bool nearestCrossing(const LevelInterpolant& level, glm::ivec3 sample, glm::ivec3 towards, glm::dvec3& nearest) {
  std::array<Corner, 8> corners;
  int inside = 0;
  for (int i = 0; i < 8; ++i) {
    Corner& corner = corners[static_cast<std::size_t>(i)];
    corner.at = towards * glm::ivec3(i & 1, i >> 1 & 1, i >> 2);
    const glm::ivec3 p = glm::clamp(sample + corner.at, glm::ivec3(0), level.level.size - 1);
    corner.level = level.level(p.x, p.y, p.z);
    inside += corner.level > 0 ? 1 : 0;
  }
  if (inside == 0 || inside == 8) return false;
  double best = std::numeric_limits<double>::max();
  for (int i = 0; i < 8; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      if ((i >> axis & 1) != 0) continue;
      const Corner& a = corners[static_cast<std::size_t>(i)];
      const Corner& b = corners[static_cast<std::size_t>(i | 1 << axis)];
      if ((a.level > 0) == (b.level > 0)) continue;
      glm::dvec3 crossing = glm::dvec3(a.at) * level.step;
      crossing[axis] += towards[axis] * level.step[axis] * (a.level / (a.level - b.level));
      if (squared(crossing) < best) {
        best = squared(crossing);
        nearest = crossing;
      }
    }
  return true;
}

}  // namespace

bool refineOffset(const LevelInterpolant& level, glm::ivec3 sample, glm::dvec3& offset) {
  const glm::dvec3 origin(sample);
  bool moved = false;
  for (int i = 0; i < kTangentSteps; ++i) {
    const glm::dvec3 position = clampToBox(level, origin + offset / level.step);
    const LevelAtPoint here = level.at(position);
    const double steepness = squared(here.gradient);
    if (!here.mixed || !(steepness > 0)) break;
    const glm::dvec3 tangential =
        alongBorder(level, position, here.gradient * (glm::dot(offset, here.gradient) / steepness) - offset);
    if (squared(tangential) < kSettled * kSettled) break;
    bool closer = false;
    double share = 1;
    for (int half = 0; half <= kHalvings && !closer; ++half, share /= 2) {
      glm::dvec3 trial = offset + share * tangential;
      if (!project(level, origin, trial) || !(squared(trial) < squared(offset))) continue;
      offset = trial;
      closer = true;
    }
    if (!closer) break;
    moved = true;
  }
  return moved;
}

bool seedOffset(const LevelInterpolant& level, glm::ivec3 sample, glm::dvec3& offset) {
  const glm::ivec3 size = level.level.size;
  bool onBorder = false;
  for (int axis = 0; axis < 3; ++axis) onBorder |= sample[axis] == 0 || sample[axis] == size[axis] - 1;
  if (onBorder && level.level(sample.x, sample.y, sample.z) > 0) {
    offset = glm::dvec3(0);
    return true;
  }
  std::array<glm::dvec3, 8> starts;
  std::size_t count = 0;
  std::size_t nearest = 0;
  for (int i = 0; i < 8; ++i) {
    const glm::ivec3 towards(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    const glm::ivec3 far = sample + towards;
    bool within = true;
    for (int axis = 0; axis < 3; ++axis) {
      const bool flat = size[axis] == 1 && towards[axis] == 1;  // one layer of cells without thickness
      within = within && (flat || (far[axis] >= 0 && far[axis] < size[axis]));
    }
    if (!within || !nearestCrossing(level, sample, towards, starts[count])) continue;
    if (squared(starts[count]) < squared(starts[nearest])) nearest = count;
    ++count;
  }
  if (count == 0) return false;
  offset = starts[nearest];
  refineOffset(level, sample, offset);
  for (std::size_t i = 0; i < count; ++i) {
    if (i == nearest) continue;
    glm::dvec3 other = starts[i];
    const LevelAtPoint there = level.at(glm::dvec3(sample) + other / level.step);
    const double toPlane = glm::dot(other, there.gradient);
    const double best = kWorthTrying * kWorthTrying * squared(offset);
    if (toPlane * toPlane >= best * squared(there.gradient) && squared(there.gradient) > 0) continue;
    refineOffset(level, sample, other);
    if (squared(other) < squared(offset)) offset = other;
  }
  return true;
}

}  // namespace isolume
