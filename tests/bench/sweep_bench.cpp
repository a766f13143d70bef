// Time and error of the distance and occlusion sweep at the grid sizes of [Singh10] Table 2 and at 256^3.
//
// Held fixed: a ball of radius .31 n (so that a third of the slices hold surface), one round of eight sweeps, all cores
// unless --threads is given by TBB's environment. Items = voxels x sweeps, so that 1 / items_per_second is the time per
// voxel and sweep. Beside each time: mean and largest error of the distance in voxels, checked after timing. The plain
// loops are the distance alone one voxel at a time on one core: compare with them in the same run, for absolute times
// drift on shared machines. A band counts all voxels of the grid, whether swept or not, and its errors are those of its
// bound; manyRounds sweeps until nothing changes; lightAlone goes through given distances. sceneOctants and sceneMean
// are light alone too, on the ball (0) and the scenes corner, gyroid and capsules (1, 2, 3) at 250^3; the distance is
// swept beside it, one for one, and `of_distance` is the smallest time of the one over that of the other.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "support/plain_sweep.h"
#include "support/test_levels.h"
#include "sweep/level.h"
#include "sweep/occlusion_sweep.h"
#include "sweep/parallel.h"
#include "tests/bench/report/timing.h"
#include "volumes/scenes.h"

namespace isolume {
namespace {

struct Ball {
  glm::ivec3 size;
  glm::dvec3 centre;
  double radius;
  Grid<float> level;
};

Ball makeBall(glm::ivec3 size) {
  Ball ball{
      size, glm::dvec3(size) * 0.5 + glm::dvec3(0.13, -0.21, 0.07), 0.31 * std::min({size.x, size.y, size.z}), {}};
  ball.level =
      test::sampleLevel(size, glm::dvec3(1), [&](glm::dvec3 p) { return ball.radius - glm::length(p - ball.centre); });
  return ball;
}

void reportError(benchmark::State& state, const Ball& ball, const float* distance) {
  double sum = 0, largest = 0;
  std::size_t i = 0;
  for (int z = 0; z < ball.size.z; ++z)
    for (int y = 0; y < ball.size.y; ++y)
      for (int x = 0; x < ball.size.x; ++x, ++i) {
        const double off = std::abs(distance[i] - (glm::length(glm::dvec3(x, y, z) - ball.centre) - ball.radius));
        sum += off;
        largest = std::max(largest, off);
      }
  state.counters["mean_error_voxels"] = sum / static_cast<double>(i);
  state.counters["max_error_voxels"] = largest;
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(i) * kOctantCount);
  state.counters["ns_per_voxel_sweep"] =
      benchmark::Counter(static_cast<double>(i) * kOctantCount * 1e-9,
                         benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

glm::ivec3 sizeOf(const benchmark::State& state) {
  return {static_cast<int>(state.range(0)), static_cast<int>(state.range(1)), static_cast<int>(state.range(2))};
}

void sweepAs(benchmark::State& state, const SweepOptions& options) {
  setThreadCount(static_cast<int>(state.range(3)));
  const Ball ball = makeBall(sizeOf(state));
  SweptFields fields;
  bench::readyMemory(ball.level.count());
  for (auto _ : state) {
    fields = {};
    fields = sweepOcclusion(ball.level.view(), options);
    benchmark::DoNotOptimize(fields.distance.data());
  }
  reportError(state, ball, fields.distance.data());
  setThreadCount(0);
}

constexpr VisibilityStorage kNone = VisibilityStorage::none;

void distanceAlone(benchmark::State& state) { sweepAs(state, {.visibility = kNone}); }
void paperStart(benchmark::State& state) { sweepAs(state, {.visibility = kNone, .start = DistanceStart::paper}); }
void manyRounds(benchmark::State& state) {
  constexpr int kMany = 1000;
  sweepAs(state, {.visibility = kNone, .rounds = kMany});
}
void bandAlone(benchmark::State& state) { sweepAs(state, {.visibility = kNone, .extent = DistanceExtent::band}); }
void eightOctants(benchmark::State& state) { sweepAs(state, {}); }

void lightAlone(benchmark::State& state) {
  setThreadCount(static_cast<int>(state.range(3)));
  const Ball ball = makeBall(sizeOf(state));
  const SweptFields fields = sweepOcclusion(ball.level.view(), {.visibility = kNone});
  bench::readyMemory(ball.level.count());
  for (auto _ : state) {
    const OctantVisibility visibility = sweepVisibility(fields.distance.view(), VisibilityStorage::rgba8);
    benchmark::DoNotOptimize(visibility.packed[0].data());
  }
  reportError(state, ball, fields.distance.data());
  setThreadCount(0);
}

void oneNumber(benchmark::State& state) { sweepAs(state, {.visibility = VisibilityStorage::combined}); }

constexpr std::array<std::string_view, 4> kScenes{"ball", "corner", "gyroid", "capsules"};

Grid<float> levelOfScene(std::size_t scene) {
  constexpr int kSize = 250;
  if (scene == 0) return makeBall(glm::ivec3(kSize)).level;
  Grid<float> level = sampleScene(*findScene(kScenes[scene]), kSize);
  makeLevel(level.view(), 0, Inside::below);
  return level;
}

void lightOfScene(benchmark::State& state, VisibilityStorage storage) {
  setThreadCount(static_cast<int>(state.range(1)));
  const auto scene = static_cast<std::size_t>(state.range(0));
  const Grid<float> level = levelOfScene(scene);
  constexpr double kForever = std::numeric_limits<double>::infinity();
  double distanceTime = kForever, lightTime = kForever;
  bench::readyMemory(level.count());
  for (auto _ : state) {
    SweptFields fields;
    distanceTime =
        std::min(distanceTime, bench::secondsOf([&] { fields = sweepOcclusion(level.view(), {.visibility = kNone}); }));
    const double seconds = bench::secondsOf([&] {
      const OctantVisibility visibility = sweepVisibility(std::as_const(fields.distance).view(), storage);
      benchmark::ClobberMemory();
    });
    lightTime = std::min(lightTime, seconds);
    state.SetIterationTime(seconds);
  }
  state.SetLabel(std::string(kScenes[scene]));
  state.counters["of_distance"] = lightTime / distanceTime;
  setThreadCount(0);
}
void sceneOctants(benchmark::State& state) { lightOfScene(state, VisibilityStorage::rgba8); }
void sceneMean(benchmark::State& state) { lightOfScene(state, VisibilityStorage::combined); }

void plainLoops(benchmark::State& state) {
  const Ball ball = makeBall(sizeOf(state));
  std::vector<float> distance;
  for (auto _ : state) distance = test::plainSweep(ball.level.view());
  reportError(state, ball, distance.data());
}

// nx, ny, nz, threads (0 = all)
void tableSizes(benchmark::internal::Benchmark* b) {
  for (const int threads : {1, 0}) {
    b->Args({101, 101, 61, threads});
    for (const int n : {100, 150, 200, 250, 256}) b->Args({n, n, n, threads});
  }
}

BENCHMARK(distanceAlone)->Apply(tableSizes)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(paperStart)->Args({256, 256, 256, 1})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(manyRounds)->Args({256, 256, 256, 1})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(bandAlone)->Apply(tableSizes)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(lightAlone)->Apply(tableSizes)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(eightOctants)->Apply(tableSizes)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(oneNumber)->Apply(tableSizes)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(sceneOctants)->ArgsProduct({{0, 1, 2, 3}, {1, 2}})->Unit(benchmark::kMillisecond)->UseManualTime();
BENCHMARK(sceneMean)->ArgsProduct({{0, 1, 2, 3}, {1, 2}})->Unit(benchmark::kMillisecond)->UseManualTime();
BENCHMARK(plainLoops)->Args({100, 100, 100, 1})->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace isolume

BENCHMARK_MAIN();
