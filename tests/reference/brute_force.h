// The judge of the exact tracer: visits every cell that a ray passes, in long double, takes the cubic from four samples
// of the interpolant, and finds its first rise by halving. Skips nothing but cells without an inside corner, which it
// reads one by one. Slow; shares no code with the tracer.
#pragma once

#include <optional>

#include "sweep/grid.h"
#include "sweep/reference/grid_ray.h"

namespace isolume::test {

/// First t from `begin` on at which f gets above 0, for f the level (or, `leaving`, minus the level) along the ray
/// within the box; nothing if it does not.
std::optional<long double> firstRiseByHalving(GridView<const float> level, const GridRay& ray, long double begin,
                                              bool leaving = false);

/// Maximum of f over [begin, end], as a share of the largest corner of the cell. What two tracers may disagree about is
/// where this is mere rounding.
long double maximumBetween(GridView<const float> level, const GridRay& ray, long double begin, long double end,
                           bool leaving = false);

/// Where the ray is in the box [0, size - 1]: entry and exit; nothing if it misses it.
struct BoxSpan {
  long double begin, end;
};
std::optional<BoxSpan> boxSpan(glm::ivec3 size, const GridRay& ray);

/// The cubic with values f[i] at i / 3 has these Bernstein coefficients; its first rise above 0 in [0, 1], by halving
/// down to 2^-60; its maximum over a part.
using LongCubic = long double[4];
void toBernstein(const LongCubic& samples, LongCubic& bernstein);
std::optional<long double> firstRiseByHalving(const LongCubic& bernstein);
long double maximumOf(const LongCubic& bernstein, long double from, long double to);

}  // namespace isolume::test
