#include "reference/brute_force.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isolume::test {
namespace {

constexpr long double kInfinity = std::numeric_limits<long double>::infinity();

void split(const LongCubic& b, long double at, LongCubic& low, LongCubic& high) {
  const auto mix = [at](long double x, long double y) { return (1 - at) * x + at * y; };
  const long double ab = mix(b[0], b[1]), bc = mix(b[1], b[2]), cd = mix(b[2], b[3]);
  const long double abc = mix(ab, bc), bcd = mix(bc, cd), middle = mix(abc, bcd);
  low[0] = b[0], low[1] = ab, low[2] = abc, low[3] = middle;
  high[0] = middle, high[1] = bcd, high[2] = cd, high[3] = b[3];
}

std::optional<long double> riseIn(const LongCubic& b, long double from, long double width) {
  if (b[0] > 0) return from;
  if (std::max({b[1], b[2], b[3]}) <= 0) return std::nullopt;
  if (width < 0x1p-60L) return b[3] > 0 ? std::optional(from) : std::nullopt;
  LongCubic low, high;
  split(b, 0.5L, low, high);
  if (const auto rise = riseIn(low, from, width / 2)) return rise;
  return riseIn(high, from + width / 2, width / 2);
}

// Raises `best` to the maximum of the cubic, to 2^-60 of `size`: halves where the hull is above that.
void raiseToMaximum(const LongCubic& b, long double size, long double& best) {
  best = std::max({best, b[0], b[3]});
  if (std::max(b[1], b[2]) <= best + 0x1p-60L * size) return;
  LongCubic low, high;
  split(b, 0.5L, low, high);
  raiseToMaximum(low, size, best);
  raiseToMaximum(high, size, best);
}

long double along(const GridRay& ray, int axis, long double t) { return ray.origin[axis] + t * ray.direction[axis]; }

struct Corners {
  long double at[2][2][2];
  long double largest = 0;
  bool anyPositive = false;

  Corners(GridView<const float> level, glm::ivec3 cell, bool leaving) {
    for (int i = 0; i < 8; ++i) {
      const glm::ivec3 bit(i & 1, (i >> 1) & 1, i >> 2);
      const long double value = level(cell.x + bit.x, cell.y + bit.y, cell.z + bit.z);
      at[bit.x][bit.y][bit.z] = leaving ? -value : value;
      anyPositive = anyPositive || (leaving ? -value : value) > 0;
      largest = std::max(largest, std::abs(value));
    }
  }
  long double value(const long double (&u)[3]) const {
    long double sum = 0;
    for (int i = 0; i < 8; ++i) {
      const int x = i & 1, y = (i >> 1) & 1, z = i >> 2;
      sum += (x ? u[0] : 1 - u[0]) * (y ? u[1] : 1 - u[1]) * (z ? u[2] : 1 - u[2]) * at[x][y][z];
    }
    return sum;
  }
};

// visit(cell, t at its begin, t at its end) for every cell between two parameters, in order, until it returns true.
template <class Visit>
void forEveryCell(glm::ivec3 size, const GridRay& ray, long double begin, long double end, const Visit& visit) {
  int plane[3];  // the next one that the ray meets along each axis
  for (int i = 0; i < 3; ++i) {
    const long double p = along(ray, i, begin);
    plane[i] = static_cast<int>(ray.direction[i] > 0 ? std::floor(p) + 1 : std::ceil(p) - 1);
  }
  for (long double t = begin; t < end;) {
    long double next = end;
    int axis = -1;
    for (int i = 0; i < 3; ++i) {
      if (ray.direction[i] == 0) continue;
      const long double meets = (plane[i] - static_cast<long double>(ray.origin[i])) / ray.direction[i];
      if (meets < next) next = meets, axis = i;
    }
    if (next > t) {
      glm::ivec3 cell;
      for (int i = 0; i < 3; ++i)
        cell[i] = std::clamp(static_cast<int>(std::floor(along(ray, i, (t + next) / 2))), 0, size[i] - 2);
      if (visit(cell, t, next)) return;
      t = next;
    }
    if (axis < 0) return;
    plane[axis] += ray.direction[axis] > 0 ? 1 : -1;
  }
}

void cubicIn(const Corners& corners, glm::ivec3 cell, const GridRay& ray, long double a, long double b,
             LongCubic& bernstein) {
  LongCubic samples;
  for (int k = 0; k < 4; ++k) {
    long double u[3];
    for (int i = 0; i < 3; ++i) u[i] = along(ray, i, a + (b - a) * k / 3) - cell[i];
    samples[k] = corners.value(u);
  }
  toBernstein(samples, bernstein);
}

}  // namespace

void toBernstein(const LongCubic& f, LongCubic& b) {
  b[0] = f[0];
  b[1] = (-5 * f[0] + 18 * f[1] - 9 * f[2] + 2 * f[3]) / 6;
  b[2] = (2 * f[0] - 9 * f[1] + 18 * f[2] - 5 * f[3]) / 6;
  b[3] = f[3];
}

std::optional<long double> firstRiseByHalving(const LongCubic& bernstein) { return riseIn(bernstein, 0, 1); }

long double maximumOf(const LongCubic& bernstein, long double from, long double to) {
  LongCubic before, rest, part, after;
  split(bernstein, from, before, rest);
  split(rest, from < 1 ? (to - from) / (1 - from) : 0, part, after);
  long double size = 0, best = -kInfinity;
  for (const long double b : bernstein) size = std::max(size, std::abs(b));
  raiseToMaximum(part, size, best);
  return best;
}

std::optional<BoxSpan> boxSpan(glm::ivec3 size, const GridRay& ray) {
  BoxSpan span{ray.start, ray.end};
  for (int i = 0; i < 3; ++i) {
    const long double origin = ray.origin[i], high = size[i] - 1;
    if (ray.direction[i] == 0) {
      if (origin < 0 || origin > high) return std::nullopt;
      continue;
    }
    const long double a = -origin / ray.direction[i], b = (high - origin) / ray.direction[i];
    span.begin = std::max(span.begin, std::min(a, b));
    span.end = std::min(span.end, std::max(a, b));
  }
  if (!(span.begin < span.end)) return std::nullopt;
  return span;
}

std::optional<long double> firstRiseByHalving(GridView<const float> level, const GridRay& ray, long double begin,
                                              bool leaving) {
  std::optional<long double> rise;
  const auto span = boxSpan(level.size, ray);
  if (!span) return rise;
  forEveryCell(level.size, ray, std::max(begin, span->begin), span->end,
               [&](glm::ivec3 cell, long double a, long double b) {
                 const Corners corners(level, cell, leaving);
                 if (!corners.anyPositive) return false;
                 LongCubic bernstein;
                 cubicIn(corners, cell, ray, a, b, bernstein);
                 if (const auto share = firstRiseByHalving(bernstein)) rise = a + *share * (b - a);
                 return rise.has_value();
               });
  return rise;
}

long double maximumBetween(GridView<const float> level, const GridRay& ray, long double begin, long double end,
                           bool leaving) {
  long double maximum = -kInfinity;
  const auto span = boxSpan(level.size, ray);
  if (!span) return maximum;
  forEveryCell(level.size, ray, std::max(begin, span->begin), std::min(end, span->end),
               [&](glm::ivec3 cell, long double a, long double b) {
                 const Corners corners(level, cell, leaving);
                 if (corners.largest == 0) return false;
                 LongCubic bernstein;
                 cubicIn(corners, cell, ray, a, b, bernstein);
                 maximum = std::max(maximum, maximumOf(bernstein, 0, 1) / corners.largest);
                 return false;
               });
  return maximum;
}

}  // namespace isolume::test
