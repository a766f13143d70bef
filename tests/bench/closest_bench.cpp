// Time and error of the closest-point distance, in one run with the first-order sweep without visibility, each over the
// whole domain and in the band, on one thread and on two.
//
// Held fixed: ball of radius .31 n, torus of radii .27 n and .11 n (tilted), and the scene "gyroid", whose surface is
// near most of the grid; one round of passes. Arguments: n, threads, and for the closest points bandVoxels. Items =
// voxels. Beside each time, except for the gyroid: mean and largest error in voxels over the whole domain and within 3
// voxels of the surface, against the closed form, checked after timing. The trilinear interpolant of the levels is
// itself off by up to .004. Compare times of one run only.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "support/test_levels.h"
#include "sweep/closest/closest_distance.h"
#include "sweep/occlusion_sweep.h"
#include "sweep/parallel.h"
#include "tests/bench/report/timing.h"
#include "volumes/scenes.h"

namespace isolume {
namespace {

using Distance = std::function<double(glm::dvec3)>;

Distance ball(double n) {
  const glm::dvec3 centre = glm::dvec3(0.51, 0.49, 0.503) * n;
  return [=](glm::dvec3 p) { return glm::length(p - centre) - 0.31 * n; };
}

Distance torus(double n) {
  const glm::dvec3 axis(0.36, 0.48, 0.8);
  return [=](glm::dvec3 p) {
    const glm::dvec3 q = p - glm::dvec3(0.5, 0.51, 0.49) * n;
    const double height = glm::dot(q, axis);
    return std::hypot(glm::length(q - height * axis) - 0.27 * n, height) - 0.11 * n;
  };
}

constexpr double kNearVoxels = 3;

void reportError(benchmark::State& state, const Distance& exact, const Grid<float>& distance) {
  double sum = 0, largest = 0, nearSum = 0, nearLargest = 0, nearCount = 0;
  const glm::ivec3 size = distance.size();
  std::size_t i = 0;
  for (int z = 0; z < size.z; ++z)
    for (int y = 0; y < size.y; ++y)
      for (int x = 0; x < size.x; ++x, ++i) {
        const double want = exact(glm::dvec3(x, y, z));
        const double off = std::abs(distance.data()[i] - want);
        sum += off;
        largest = std::max(largest, off);
        if (std::abs(want) > kNearVoxels) continue;
        nearSum += off;
        nearLargest = std::max(nearLargest, off);
        ++nearCount;
      }
  state.counters["mean_error"] = sum / static_cast<double>(i);
  state.counters["max_error"] = largest;
  state.counters["near_mean_error"] = nearSum / nearCount;
  state.counters["near_max_error"] = nearLargest;
}

enum class Way { sweep, sweepBand, full, band };

// `exact` may be empty: no errors then.
void run(benchmark::State& state, const Grid<float>& level, const Distance& exact, Way way) {
  setThreadCount(static_cast<int>(state.range(1)));
  Grid<float> distance;
  bench::readyMemory(level.count());
  for (auto _ : state) {
    distance = {};
    const auto extent = way == Way::full || way == Way::sweep ? DistanceExtent::full : DistanceExtent::band;
    if (way == Way::sweep || way == Way::sweepBand) {
      distance = sweepOcclusion(level.view(), {.visibility = VisibilityStorage::none, .extent = extent}).distance;
    } else {
      distance = closestDistance(level.view(), {.extent = extent, .bandVoxels = static_cast<int>(state.range(2))});
    }
    benchmark::DoNotOptimize(distance.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(level.count()));
  if (exact && (way == Way::sweep || way == Way::full)) reportError(state, exact, distance);
  setThreadCount(0);
}

template <Way way>
void ofShape(benchmark::State& state, Distance (*shape)(double)) {
  const int n = static_cast<int>(state.range(0));
  const Distance exact = shape(n);
  run(state, test::sampleLevel(glm::ivec3(n), glm::dvec3(1), [&](glm::dvec3 p) { return -exact(p); }), exact, way);
}
template <Way way>
void ofBall(benchmark::State& state) {
  ofShape<way>(state, ball);
}
template <Way way>
void ofTorus(benchmark::State& state) {
  ofShape<way>(state, torus);
}
template <Way way>
void ofGyroid(benchmark::State& state) {
  const int n = static_cast<int>(state.range(0));
  const Scene* scene = findScene("gyroid");
  run(state,
      test::sampleLevel(glm::ivec3(n), glm::dvec3(1),
                        [&](glm::dvec3 p) { return -n * static_cast<double>(scene->value(p / double(n))); }),
      {}, way);
}

void closestArguments(benchmark::internal::Benchmark* b) {
  for (const int threads : {1, 2}) b->Args({250, threads, 3});
}
// What each layer of the band costs and gains, and how time grows with the grid.
void moreArguments(benchmark::internal::Benchmark* b) {
  closestArguments(b);
  for (const int band : {0, 1, 2}) b->Args({250, 1, band});
  for (const int n : {128, 256, 512}) b->Args({n, 2, 3});
}
void sweepArguments(benchmark::internal::Benchmark* b) {
  for (const int threads : {1, 2}) b->Args({250, threads});
}

BENCHMARK(ofBall<Way::sweep>)->Apply(sweepArguments)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(ofBall<Way::full>)->Apply(moreArguments)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(ofBall<Way::band>)->Apply(moreArguments)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(ofBall<Way::sweepBand>)->Apply(sweepArguments)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(ofTorus<Way::sweep>)->Apply(sweepArguments)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(ofTorus<Way::sweepBand>)->Apply(sweepArguments)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(ofTorus<Way::full>)->Apply(closestArguments)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(ofTorus<Way::band>)->Apply(closestArguments)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(ofGyroid<Way::sweep>)->Apply(sweepArguments)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(ofGyroid<Way::sweepBand>)->Apply(sweepArguments)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(ofGyroid<Way::full>)->Apply(closestArguments)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(ofGyroid<Way::band>)->Apply(closestArguments)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace isolume

BENCHMARK_MAIN();
