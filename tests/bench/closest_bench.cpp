// Time and error of the closest-point distance, in one run with the first-order sweep without visibility.
//
// Held fixed: ball of radius .31 n and torus of radii .27 n and .11 n (tilted), one round of passes. Arguments: n,
// band, threads (0 = all). Items = voxels. Beside each time: mean and largest error in voxels over the whole domain and
// within 3 voxels of the surface, against the closed form, checked after timing. Compare times of one run only.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "support/test_levels.h"
#include "sweep/closest/closest_distance.h"
#include "sweep/occlusion_sweep.h"
#include "sweep/parallel.h"

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
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(i));
}

void run(benchmark::State& state, Distance (*shape)(double), bool closest) {
  setThreadCount(static_cast<int>(state.range(2)));
  const int n = static_cast<int>(state.range(0));
  const int band = static_cast<int>(state.range(1));
  const Distance exact = shape(n);
  const Grid<float> level = test::sampleLevel(glm::ivec3(n), glm::dvec3(1), [&](glm::dvec3 p) { return -exact(p); });
  Grid<float> distance;
  for (auto _ : state) {
    distance = {};
    if (closest) {
      distance = closestDistance(level.view(), {.band = band});
    } else {
      distance = sweepOcclusion(level.view(), {.visibility = VisibilityStorage::none}).distance;
    }
    benchmark::DoNotOptimize(distance.data());
  }
  reportError(state, exact, distance);
  setThreadCount(0);
}

void closestOfBall(benchmark::State& state) { run(state, ball, true); }
void closestOfTorus(benchmark::State& state) { run(state, torus, true); }
void sweepOfBall(benchmark::State& state) { run(state, ball, false); }
void sweepOfTorus(benchmark::State& state) { run(state, torus, false); }

void bands(benchmark::internal::Benchmark* b) {
  for (const int threads : {1, 0})
    for (const int n : {128, 250})
      for (const int band : {0, 1, 2, 3}) b->Args({n, band, threads});
}
void noBand(benchmark::internal::Benchmark* b) {
  for (const int threads : {1, 0})
    for (const int n : {128, 250}) b->Args({n, 0, threads});
}

BENCHMARK(closestOfBall)->Apply(bands)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(closestOfTorus)->Apply(bands)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(sweepOfBall)->Apply(noBand)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(sweepOfTorus)->Apply(noBand)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace isolume

BENCHMARK_MAIN();
