#include "closest_point.h"

#include <algorithm>

#include "block_crossings.h"

namespace isolume {
namespace {

constexpr int kSteps = 8;            // Newton's method doubles the digits: most stop after two
constexpr int kProjections = 5;      // the same; a linear f needs one step and one check
constexpr int kHalvings = 2;         // of a tangential step that led further away
constexpr double kSettled = 1e-6;    // a step t this short is not worth it: it shortens the distance d by t^2 / (2 d)
constexpr double kLongestJump = 3;   // a projection longer than this, in smallest spacings, has lost its sheet
constexpr double kWorthTrying = .9;  // of the best distance: the tangent plane of another start must be this near
double squared(glm::dvec3 v) { return glm::dot(v, v); }

// Drops the parts of `direction` that lead out of the box at `position`.
inline glm::dvec3 alongBorder(const LevelInterpolant& level, glm::dvec3 position, glm::dvec3 direction) {
  for (int axis = 0; axis < 3; ++axis) {
    const bool low = position[axis] <= 0 && direction[axis] < 0;
    const bool high = position[axis] >= level.level.size[axis] - 1 && direction[axis] > 0;
    if (low || high) direction[axis] = 0;
  }
  return direction;
}

// A trial point of the surface and what the interpolant says there.
struct Foot {
  glm::dvec3 offset{0};
  glm::dvec3 position{0};
  LevelAtPoint level;
};

Foot footAt(const LevelInterpolant& level, glm::dvec3 origin, glm::dvec3 offset) {
  Foot foot;
  foot.position = glm::min(glm::max(origin + offset * level.inverse, glm::dvec3(0)), level.last);
  foot.offset = (foot.position - origin) * level.step;
  foot.level = level.at(foot.position);
  return foot;
}

// Newton onto the surface, from `offset`.
bool project(const LevelInterpolant& level, glm::dvec3 origin, glm::dvec3 offset, Foot& foot) {
  for (int i = 0; i < kProjections; ++i) {
    foot = footAt(level, origin, offset);
    const LevelAtPoint& here = foot.level;
    const double steepness = squared(here.gradient);
    if (!here.mixed || !(steepness > 0)) return false;
    if (here.value * here.value <= kOnSurface * kOnSurface * steepness) return true;
    const glm::dvec3 direction = alongBorder(level, foot.position, here.value > 0 ? -here.gradient : here.gradient);
    const double slope = squared(direction);
    if (!(slope > 0)) return false;
    const glm::dvec3 move = direction * (std::abs(here.value) / slope);
    if (!(squared(move) < kLongestJump * kLongestJump)) return false;
    offset = foot.offset + move;
    // A short last step needs no second look: within the cell the interpolant leaves its tangent plane by `bend` at
    // most.
    const double left = here.bend * squared(move);
    if (slope < steepness || squared(move) > 1 || left * left > kOnSurface * kOnSurface * steepness) continue;
    const glm::dvec3 position = origin + offset * level.inverse;
    if (!level.sameCell(foot.position, position)) continue;
    foot.offset = offset;
    foot.position = position;
    foot.level.value = 0;
    return true;
  }
  return false;
}

// The step dp of Newton's method; false where the matrix is not positive (v beyond the centre of curvature). With
// A = adj(I + m H): dp = -(A o + m' A g) / det, m' = (f det - g . A o) / (g . A g), o = p - v.
bool newtonStep(const Foot& foot, double steepness, glm::dvec3& step) {
  const glm::dvec3 g = foot.level.gradient;
  const glm::dvec3 o = foot.offset;
  const glm::dvec3 h = foot.level.twist * (-glm::dot(o, g) / steepness);
  const glm::dvec3 diagonal = 1.0 - h * h;
  const glm::dvec3 off(h.y * h.z - h.x, h.x * h.z - h.y, h.x * h.y - h.z);  // yz, xz, xy
  const auto adjugate = [&](glm::dvec3 u) {
    return glm::dvec3(diagonal.x * u.x + off.z * u.y + off.y * u.z, off.z * u.x + diagonal.y * u.y + off.x * u.z,
                      off.y * u.x + off.x * u.y + diagonal.z * u.z);
  };
  const double determinant = diagonal.x + h.z * off.z + h.y * off.y;
  const glm::dvec3 adjugateO = adjugate(o);
  const glm::dvec3 adjugateG = adjugate(g);
  const double along = glm::dot(g, adjugateG);
  if (!(determinant > 0) || !(along > 0)) return false;
  const double multiplier = (foot.level.value * determinant - glm::dot(g, adjugateO)) / along;
  step = -(adjugateO + multiplier * adjugateG) / determinant;
  return true;
}

// refineOffset() from the foot of a known point.
bool refineFoot(const LevelInterpolant& level, glm::dvec3 origin, Foot& foot) {
  Foot trial;
  bool moved = false;
  for (int i = 0; i < kSteps; ++i) {
    const LevelAtPoint& here = foot.level;
    const double steepness = squared(here.gradient);
    if (!here.mixed || !(steepness > 0)) break;
    const glm::dvec3 towardsFoot = here.gradient * (glm::dot(foot.offset, here.gradient) / steepness) - foot.offset;
    const glm::dvec3 tangential = alongBorder(level, foot.position, towardsFoot);
    const double gain = squared(tangential) / 2;  // times the distance
    if (gain * gain <= kSettled * kSettled * squared(foot.offset)) break;
    const auto closerBy = [&](glm::dvec3 step) {
      return project(level, origin, foot.offset + step, trial) && squared(trial.offset) < squared(foot.offset);
    };
    glm::dvec3 step(0);
    bool closer = newtonStep(foot, steepness, step) && closerBy(alongBorder(level, foot.position, step));
    double share = 1;
    for (int half = 0; half <= kHalvings && !closer; ++half, share /= 2) closer = closerBy(share * tangential);
    if (!closer) break;
    foot = trial;
    moved = true;
  }
  return moved;
}

// Does `point` lie on the tangent plane at `foot`, as seen from there?
bool onTangentPlane(const Foot& foot, glm::dvec3 point) {
  const glm::dvec3 across = point - foot.offset;
  const double along = glm::dot(across, foot.level.gradient);
  return along * along <= kSameSheet * kSameSheet * squared(across) * squared(foot.level.gradient);
}

}  // namespace

bool refineOffset(const LevelInterpolant& level, glm::ivec3 sample, glm::dvec3& offset) {
  const glm::dvec3 origin(sample);
  Foot foot = footAt(level, origin, offset);
  if (!refineFoot(level, origin, foot)) return false;
  offset = foot.offset;
  return true;
}

bool seedOffset(const LevelInterpolant& level, glm::ivec3 sample, glm::dvec3& offset) {
  const glm::ivec3 size = level.level.size;
  bool onBorder = false;
  for (int axis = 0; axis < 3; ++axis) onBorder |= sample[axis] == 0 || sample[axis] == size[axis] - 1;
  if (onBorder && level.level(sample.x, sample.y, sample.z) > 0) {
    offset = glm::dvec3(0);
    return true;
  }
  BlockCrossings crossings;
  findCrossings(level, sample, crossings);
  const auto nearest = static_cast<std::size_t>(std::min_element(crossings.squared.begin(), crossings.squared.end()) -
                                                crossings.squared.begin());
  if (crossings.nearest[nearest] == kNoCrossing) return false;
  const glm::dvec3 origin(sample);
  // Cells share their edges, so many starts are the same point.
  unsigned long long tried = 1ULL << crossings.nearest[nearest];
  offset = crossings.offset[static_cast<std::size_t>(crossings.nearest[nearest])];
  Foot best = footAt(level, origin, offset);
  if (refineFoot(level, origin, best)) offset = best.offset;
  for (const int start : crossings.nearest) {
    if (start == kNoCrossing || (tried >> start & 1) != 0) continue;
    tried |= 1ULL << start;
    const glm::dvec3 other = crossings.offset[static_cast<std::size_t>(start)];
    if (squared(best.level.gradient) > 0 && onTangentPlane(best, other)) continue;
    Foot foot = footAt(level, origin, other);
    const double toPlane = glm::dot(other, foot.level.gradient);
    const double steepness = squared(foot.level.gradient);
    if (steepness > 0 && toPlane * toPlane >= kWorthTrying * kWorthTrying * squared(offset) * steepness) continue;
    const glm::dvec3 found = refineFoot(level, origin, foot) ? foot.offset : other;
    if (!(squared(found) < squared(offset))) continue;
    offset = found;
    best = foot;
  }
  return true;
}

}  // namespace isolume
