#include "reference/hit_judge.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "reference/brute_force.h"
#include "reference/random_rays.h"
#include "sweep/parallel.h"

namespace isolume::test {
namespace {

constexpr long double kSamePlace = 1e-9L;  // voxels
constexpr long double kRounding = 0x1p-38L;

std::string describe(const GridRay& ray, const char* what, long double got, long double want) {
  const auto text = [](glm::dvec3 v) {
    char buffer[100];
    std::snprintf(buffer, sizeof buffer, "(%.17g, %.17g, %.17g)", v.x, v.y, v.z);
    return std::string(buffer);
  };
  char ends[100];
  std::snprintf(ends, sizeof ends, ": got t = %.15Lg, want %.15Lg", got, want);
  return what + std::string(" of ") + text(ray.origin) + " + t " + text(ray.direction) + ends;
}

void fail(HitCounts& counts, const std::string& what) {
  if (counts.wrong++ == 0) counts.firstWrong = what;
}

// Whether between two parameters, and a hair before the later one, the level is at most rounding, as a share of the
// corners of its cell.
bool isTie(GridView<const float> level, const GridRay& ray, long double a, long double b, long double rounding,
           bool leaving = false) {
  const long double hair = kSamePlace / glm::length(ray.direction);
  return maximumBetween(level, ray, std::min(a, b), std::max(a, b) - hair, leaving) <= rounding;
}

// Whether the ray comes into the box from outside, or starts on its border and goes in.
bool comesFromOutside(glm::ivec3 size, const GridRay& ray, long double begin) {
  if (begin > ray.start) return true;
  for (int i = 0; i < 3; ++i) {
    if (ray.direction[i] > 0 && ray.origin[i] == 0) return true;
    if (ray.direction[i] < 0 && ray.origin[i] == size[i] - 1) return true;
  }
  return false;
}

bool isOnRay(const GridRay& ray, const SurfacePoint& hit) {
  // Rounding of t times the direction: 2^-52 of the way, some 1e4 voxels.
  const glm::dvec3 off = hit.position - (ray.origin + hit.t * ray.direction);
  return glm::length(off) < 1e-11;
}

void judgeFirst(const SurfaceTracer& tracer, const GridRay& ray, const std::optional<SurfacePoint>& got,
                HitCounts& counts) {
  const auto level = tracer.level();
  ++counts.rays;
  const auto span = boxSpan(level.size, ray);
  const long double length = glm::length(ray.direction);
  if (!span || (span->end - span->begin) * length < kSamePlace) {
    if (got && !span) fail(counts, describe(ray, "hit outside the box", got->t, 0));
    return;
  }
  // 0 where the level is mere rounding at the start, so that either way is right.
  const long double atStart = maximumBetween(level, ray, span->begin, span->begin + kSamePlace / length);
  const bool isInside = tracer.levelAt(glm::clamp(ray.origin + static_cast<double>(span->begin) * ray.direction,
                                                  glm::dvec3(0), glm::dvec3(level.size - 1))) > 0;
  if (std::abs(atStart) < kSamePlace && atStart != 0) return;
  const bool fromOutside = comesFromOutside(level.size, ray, span->begin);
  std::optional<long double> want;
  bool wantCap = false;
  const bool leaving = isInside && !fromOutside;
  if (isInside && fromOutside) {
    want = span->begin;
    wantCap = true;
  } else {
    want = firstRiseByHalving(level, ray, span->begin, leaving);
    if (leaving && !want) {
      want = span->end;
      wantCap = true;
    }
  }
  counts.inside += leaving;
  counts.caps += wantCap;
  counts.hits += want.has_value() && !leaving && !wantCap;
  const long double gotAt = got ? got->t : span->end, wantAt = want ? *want : span->end;
  if (got && !isOnRay(ray, *got)) return fail(counts, describe(ray, "place", gotAt, wantAt));
  const bool same = got.has_value() == want.has_value() && std::abs(gotAt - wantAt) * length < kSamePlace;
  if (same && (!got || (got->capAxis >= 0) == wantCap)) return;
  if (isTie(level, ray, gotAt, wantAt, kRounding, leaving)) {
    ++counts.ties;
  } else {
    fail(counts, describe(ray, "first hit", gotAt, wantAt));
  }
}

void judgeNext(const SurfaceTracer& tracer, const SurfacePoint& from, glm::dvec3 direction, HitCounts& counts) {
  const auto level = tracer.level();
  GridRay ray;
  ray.origin = from.position;
  ray.direction = direction;
  const auto got = tracer.nextHit(ray, from);
  ++counts.leaving;
  counts.blocked += got.has_value();
  if (tracer.isBlocked(ray, from) != got.has_value()) return fail(counts, describe(ray, "isBlocked", 0, 0));
  const auto span = boxSpan(level.size, ray);
  const double hair = 1e-7;
  if (!span || span->end < hair) return;
  // The level one hair on, from the start: what the ray does at its start, unless that is too little to tell.
  const glm::dvec3 near = from.position + hair * direction;
  const glm::ivec3 cell = glm::clamp(glm::ivec3(glm::floor(near)), glm::ivec3(0), level.size - 2);
  double largest = 0;
  for (int i = 0; i < 8; ++i)
    largest = std::max<double>(largest, std::abs(level(cell.x + (i & 1), cell.y + ((i >> 1) & 1), cell.z + (i >> 2))));
  const double slope = tracer.levelAt(near) / (hair * largest);
  // The level's own rounding over a hair is 1e-6 of that. In the next cell the slope is another.
  const glm::dvec3 within = glm::clamp(from.position, glm::dvec3(cell), glm::dvec3(cell + 1));
  if (std::abs(slope) < 1e-3 || within != from.position) {
    ++counts.grazing;
    return;
  }
  if (slope > 0) {
    if (!got || got->t > hair) fail(counts, describe(ray, "hit at once", got ? got->t : span->end, 0));
    return;
  }
  const auto want = firstRiseByHalving(level, ray, hair);
  const long double gotAt = got ? got->t : span->end, wantAt = want ? *want : span->end;
  if (got.has_value() == want.has_value() && std::abs(gotAt - wantAt) < kSamePlace) return;
  // The tracer counts a point of such a ray as inside from 2^-38 on; one more for the rounding.
  if (gotAt > hair && isTie(level, ray, gotAt, wantAt, 2 * kRounding)) {
    ++counts.ties;
  } else {
    fail(counts, describe(ray, "next hit", gotAt, wantAt));
  }
}

}  // namespace

HitCounts& HitCounts::operator+=(const HitCounts& other) {
  if (wrong == 0) firstWrong = other.firstWrong;
  rays += other.rays, hits += other.hits, inside += other.inside, caps += other.caps, ties += other.ties;
  leaving += other.leaving, blocked += other.blocked, grazing += other.grazing, wrong += other.wrong;
  return *this;
}

std::string HitCounts::text() const {
  const auto number = [](std::int64_t n) { return std::to_string(n); };
  return number(rays) + " rays: " + number(hits) + " hits, " + number(inside) + " from inside, " + number(caps) +
         " on caps, " + number(ties) + " ties; " + number(leaving) + " rays on: " + number(blocked) + " blocked, " +
         number(grazing) + " grazing; " + number(wrong) + " wrong";
}

HitCounts judgeHits(const SurfaceTracer& tracer, std::int64_t first, std::int64_t count) {
  constexpr std::int64_t kChunk = 1000;
  std::vector<HitCounts> chunks(static_cast<std::size_t>((count + kChunk - 1) / kChunk));
  parallelFor(chunks.size(), [&](std::size_t chunk) {
    const std::int64_t begin = static_cast<std::int64_t>(chunk) * kChunk;
    for (std::int64_t i = begin; i < std::min(count, begin + kChunk); ++i) {
      const auto number = static_cast<std::uint64_t>(first + i);
      const GridRay ray = randomRay(tracer.level().size, number);
      const auto hit = tracer.firstHit(ray);
      judgeFirst(tracer, ray, hit, chunks[chunk]);
      // Another stream of numbers than that of the rays.
      if (hit && hit->capAxis < 0) judgeNext(tracer, *hit, Random(~number).direction(), chunks[chunk]);
    }
  });
  HitCounts sum;
  for (const HitCounts& chunk : chunks) sum += chunk;
  return sum;
}

}  // namespace isolume::test
