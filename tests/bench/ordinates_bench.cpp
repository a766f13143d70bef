// Openness by ordinates: rays as bits, and light from voxel to voxel in 15 bits (`transported`: step, inner ramp),
// against the scalar sweep of [Singh10] Eq. 6 along one ordinate.
//
// Held fixed: the scene (gyroid), and the distance, swept beforehand. Items are voxels times ordinates, so that
// items_per_second compares all; arguments: samples along each axis, ordinates, refinement (rays only), threads. The
// time of `openness` and `transported` holds everything from the level and the distance to the result. What it is
// worth: its error is in src/jobs/occlusion_calibration.json (report_calibration).
#include <benchmark/benchmark.h>

#include <cmath>
#include <vector>

#include "sweep/level.h"
#include "sweep/occlusion_sweep.h"
#include "sweep/ordinates/openness_sweep.h"
#include "sweep/ordinates/ordinate_set.h"
#include "sweep/parallel.h"
#include "sweep/transport/transport_sweep.h"
#include "tests/bench/report/timing.h"
#include "volumes/scenes.h"

namespace isolume {
namespace {

struct SweptLevel {
  Grid<float> level, distance;
  explicit SweptLevel(int size) : level(sampleScene(*findScene("gyroid"), size)) {
    makeLevel(level.view(), 0, Inside::below);
    SweepOptions options;
    options.visibility = VisibilityStorage::none;
    distance = sweepOcclusion(std::as_const(level).view(), options).distance;
  }
};

void openness(benchmark::State& state) {
  const SweptLevel scene(static_cast<int>(state.range(0)));
  const OrdinateOptions options{.ordinates = static_cast<int>(state.range(1)),
                                .refinement = static_cast<int>(state.range(2))};
  setThreadCount(static_cast<int>(state.range(3)));
  SurfaceField swept;
  bench::readyMemory(scene.level.count());
  for (auto _ : state) swept = sweepOpenness(scene.level.view(), scene.distance.view(), options);
  setThreadCount(0);
  std::size_t known = 0;
  for (const std::uint16_t number : swept.numbers()) known += number > 0 ? 1 : 0;
  state.counters["known_share"] = static_cast<double>(known) / static_cast<double>(voxelCount(swept.paddedSize()));
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(scene.level.count()) * options.ordinates);
}
BENCHMARK(openness)
    ->Args({256, 128, 1, 1})
    ->Args({256, 128, 1, 2})
    ->Args({256, 512, 1, 1})
    ->Args({256, 512, 1, 2})
    ->Args({256, 1024, 2, 1})
    ->Args({256, 1024, 2, 2})
    ->Args({512, 128, 1, 2})
    ->Args({512, 512, 1, 2})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

void transported(benchmark::State& state) {
  const SweptLevel scene(static_cast<int>(state.range(0)));
  const TransportOptions options{.ordinates = static_cast<int>(state.range(1))};
  setThreadCount(static_cast<int>(state.range(2)));
  bench::readyMemory(scene.level.count());
  for (auto _ : state) {
    SurfaceField swept = sweepTransport(scene.level.view(), scene.distance.view(), options);
    benchmark::DoNotOptimize(&swept);
  }
  setThreadCount(0);
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(scene.level.count()) * options.ordinates);
}
BENCHMARK(transported)
    ->Args({256, 72, 1})
    ->Args({256, 128, 1})
    ->Args({256, 128, 2})
    ->Args({256, 512, 1})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

// One thread, one float per voxel, a direction of the first octant.
void scalarOrdinate(benchmark::State& state) {
  const SweptLevel scene(static_cast<int>(state.range(0)));
  const GridView<const float> distance = scene.distance.view();
  const glm::ivec3 size = distance.size;
  const auto unit = static_cast<float>(smallestSpacing(distance.spacing));
  const float weights[3] = {0.2F, 0.5F, 0.3F};
  std::vector<float> light(distance.count());
  for (auto _ : state) {
    for (int z = 0; z < size.z; ++z)
      for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
          const std::size_t at = distance.index(x, y, z);
          const auto from = [&](bool within, std::ptrdiff_t stride) {
            return within ? light[at - static_cast<std::size_t>(stride)] : 1.0F;
          };
          const float arriving = weights[0] * from(x > 0, 1) + weights[1] * from(y > 0, distance.strideY()) +
                                 weights[2] * from(z > 0, distance.strideZ());
          light[at] = arriving * std::fmin(std::fmax(distance.data[at] / unit + 1, 0.0F), 1.0F);
        }
    benchmark::DoNotOptimize(light.data());
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(light.size()));
}
BENCHMARK(scalarOrdinate)->Arg(256)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace isolume

BENCHMARK_MAIN();
