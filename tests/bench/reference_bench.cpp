// Rays of the Monte Carlo reference on the 256^3 gyroid: from afar to the surface, and from the surface outwards.
//
// Held fixed: scene, 2^16 rays per iteration, one thread, rays in random order (the worst case for caches). Items are
// rays. After timing, the share that meets something is shown, and each tenth ray from the surface is traced once more
// the other way: a ray is blocked where it has a next hit, and only there.
#include <benchmark/benchmark.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <random>
#include <vector>

#include "sweep/level.h"
#include "sweep/reference/directions.h"
#include "sweep/reference/surface_tracer.h"
#include "volumes/scenes.h"

namespace isolume {
namespace {

constexpr int kSize = 256;
constexpr std::size_t kRays = 1 << 16;

struct Leaving {
  GridRay ray;
  SurfacePoint from;
};

struct Bench {
  Grid<float> level = sampleScene(*findScene("gyroid"), kSize);
  std::optional<SurfaceTracer> tracer;
  std::vector<GridRay> fromAfar;
  std::vector<Leaving> fromSurface;

  Bench() {
    makeLevel(level.view(), 0, Inside::below);
    tracer.emplace(level.view());
    std::mt19937 engine(1);
    const auto uniform = [&engine] { return static_cast<double>(engine()) / 4294967296.0; };
    const auto anywhere = [&] { return directionAt(2 * uniform() - 1, uniform()); };
    const glm::dvec3 centre(0.5 * (kSize - 1));
    while (fromSurface.size() < kRays) {
      // From a sphere around the grid to a point of the ball within it.
      const glm::dvec3 origin = centre + 1.0 * kSize * anywhere();
      const glm::dvec3 target = centre + 0.4 * kSize * std::cbrt(uniform()) * anywhere();
      const GridRay ray{origin, glm::normalize(target - origin)};
      if (fromAfar.size() < kRays) fromAfar.push_back(ray);
      const std::optional<SurfacePoint> hit = tracer->firstHit(ray);
      if (!hit || hit->capAxis >= 0) continue;
      const glm::dvec3 normal = -glm::normalize(tracer->cellGradient(hit->position));
      const glm::dvec3 direction = frameAbout(normal) * cosineDirection({uniform(), uniform()});
      fromSurface.push_back({{hit->position, direction}, *hit});
    }
  }
};

const Bench& bench() {
  static const Bench instance;
  return instance;
}

void firstHit(benchmark::State& state) {
  bench();  // made before the clock starts
  std::size_t hits = 0;
  for (auto _ : state) {
    hits = 0;
    for (const GridRay& ray : bench().fromAfar) hits += bench().tracer->firstHit(ray).has_value();
  }
  state.counters["hit_share"] = static_cast<double>(hits) / kRays;
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kRays));
}

void isBlocked(benchmark::State& state) {
  bench();
  std::size_t blocked = 0;
  for (auto _ : state) {
    blocked = 0;
    for (const Leaving& leaving : bench().fromSurface) blocked += bench().tracer->isBlocked(leaving.ray, leaving.from);
  }
  constexpr std::size_t kJudged = 10;
  for (std::size_t i = 0; i < kRays; i += kJudged) {
    const Leaving& leaving = bench().fromSurface[i];
    if (bench().tracer->isBlocked(leaving.ray, leaving.from) !=
        bench().tracer->nextHit(leaving.ray, leaving.from).has_value())
      state.SkipWithError("isBlocked and nextHit disagree");
  }
  state.counters["blocked_share"] = static_cast<double>(blocked) / kRays;
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(kRays));
}

BENCHMARK(firstHit)->Unit(benchmark::kMillisecond);
BENCHMARK(isBlocked)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace isolume

BENCHMARK_MAIN();
