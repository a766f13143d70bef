// What light costs by ordinates, gyroid, two threads: a white sky, a coloured map, a sun and light through the solid,
// each from levels and distances to the fields that are drawn; and one reflection.
//
// Held fixed: the scene, 256 samples along each axis, the distance, swept beforehand. The argument is the number of
// ordinates. What each is worth: docs/gallery.md, beside its reference.
#include <benchmark/benchmark.h>

#include <utility>
#include <vector>

#include "sweep/level.h"
#include "sweep/occlusion_sweep.h"
#include "sweep/ordinates/inter_reflection.h"
#include "sweep/ordinates/light_sweeps.h"
#include "sweep/ordinates/openness_sweep.h"
#include "sweep/ordinates/sky_ordinates.h"
#include "sweep/ordinates/translucency.h"
#include "volumes/scenes.h"

namespace isolume {
namespace {

constexpr int kSize = 256;

struct Scene {
  Grid<float> level, distance;
  Scene() : level(sampleScene(*findScene("gyroid"), kSize)) {
    makeLevel(level.view(), 0, Inside::below);
    SweepOptions options;
    options.visibility = VisibilityStorage::none;
    distance = sweepOcclusion(std::as_const(level).view(), options).distance;
  }
  SurfaceRays rays() const { return {level.view(), distance.view(), 1}; }
};
const Scene& scene() {
  static const Scene made;
  return made;
}

int ordinates(const benchmark::State& state) { return static_cast<int>(state.range(0)); }

void whiteSky(benchmark::State& state) {
  scene();
  for (auto _ : state)
    benchmark::DoNotOptimize(
        sweepOpenness(scene().level.view(), scene().distance.view(), {.ordinates = ordinates(state)}));
}

void colouredMap(benchmark::State& state) {
  constexpr glm::ivec2 kMap(1024, 512);
  std::vector<glm::vec3> radiance;
  for (int i = 0; i < kMap.x * kMap.y; ++i) radiance.emplace_back(i % 7, i % 5, i % 3);
  for (auto _ : state)
    benchmark::DoNotOptimize(
        sweepSky(scene().rays(), mappedSky(ordinates(state), kMap, radiance, 0, glm::dmat3(1)), 3));
}

void sun(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(sweepDisc(scene().rays(), {1, 2, 3}, 5, ordinates(state)));
}

void translucent(benchmark::State& state) {
  for (auto _ : state)
    benchmark::DoNotOptimize(
        sweepTranslucency(scene().rays(), scene().distance.view(), uniformSky(ordinates(state)), 0.05));
}

void reflection(benchmark::State& state) {
  const SurfaceRays rays = scene().rays();
  const std::vector<float> blocked = blockedShares(rays, ordinates(state));
  std::vector<float> direct(blocked.size());
  for (std::size_t i = 0; i < direct.size(); ++i) direct[i] = 1 - blocked[i];
  const InterReflection reflections(rays, ordinates(state));
  for (auto _ : state) benchmark::DoNotOptimize(reflections.reflect(direct, blocked, 0.6F, 1, {.bounces = 1}));
}

void allReflections(benchmark::State& state) {
  const SurfaceRays rays = scene().rays();
  const std::vector<float> blocked = blockedShares(rays, ordinates(state));
  std::vector<float> direct(blocked.size());
  for (std::size_t i = 0; i < direct.size(); ++i) direct[i] = 1 - blocked[i];
  int bounces = 0;
  for (auto _ : state) {
    const InterReflection reflections(rays, ordinates(state));
    bounces = reflections.reflect(direct, blocked, 0.6F, 1, {}).bounces;
  }
  state.counters["bounces"] = bounces;
}

BENCHMARK(whiteSky)->Arg(72)->Arg(512)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(colouredMap)->Arg(72)->Arg(512)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(sun)->Arg(62)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(translucent)->Arg(72)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(reflection)->Arg(72)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(allReflections)->Arg(72)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace isolume

BENCHMARK_MAIN();
