// The distance of other libraries beside ours, on the same ball in the same run: time, and error against the exact
// distance over the voxels that both define. Held fixed: 250^3, exact signed distances as input values (what each
// library then makes of them is what is measured), all cores. Ours builds the whole domain, as they do.
#include <benchmark/benchmark.h>
#include <openvdb/openvdb.h>
#include <openvdb/tools/Dense.h>
#include <openvdb/tools/FastSweeping.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "support/test_levels.h"
#include "sweep/occlusion_sweep.h"

namespace isolume {
namespace {

constexpr int kSize = 250;
constexpr double kRadius = 0.31 * kSize;
const glm::dvec3 kCentre(125.13, 124.79, 125.07);

double exactDistance(int x, int y, int z) { return glm::length(glm::dvec3(x, y, z) - kCentre) - kRadius; }

template <class DistanceAt>
void reportError(benchmark::State& state, const DistanceAt& distanceAt) {
  double sum = 0, largest = 0;
  for (int z = 0; z < kSize; ++z)
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) {
        const double off = std::abs(distanceAt(x, y, z) - exactDistance(x, y, z));
        sum += off;
        largest = std::max(largest, off);
      }
  state.counters["mean_error_voxels"] = sum / std::pow(static_cast<double>(kSize), 3);
  state.counters["max_error_voxels"] = largest;
}

void isolumeDistance(benchmark::State& state) {
  const Grid<float> level = test::ballLevel(kSize, kRadius, kCentre);
  SweptFields fields;
  for (auto _ : state) {
    fields = {};
    fields = sweepOcclusion(level.view(), {.visibility = VisibilityStorage::none});
  }
  reportError(state, [&](int x, int y, int z) { return fields.distance.view()(x, y, z); });
}

void isolumeDistanceAndOctants(benchmark::State& state) {
  const Grid<float> level = test::ballLevel(kSize, kRadius, kCentre);
  SweptFields fields;
  for (auto _ : state) {
    fields = {};
    fields = sweepOcclusion(level.view());
  }
  reportError(state, [&](int x, int y, int z) { return fields.distance.view()(x, y, z); });
}

void openVdbFastSweeping(benchmark::State& state) {
  openvdb::initialize();
  const openvdb::CoordBBox box(openvdb::Coord(0), openvdb::Coord(kSize - 1));
  openvdb::tools::Dense<float, openvdb::tools::LayoutXYZ> dense(box);
  for (int z = 0; z < kSize; ++z)
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x)
        dense.setValue(openvdb::Coord(x, y, z), static_cast<float>(exactDistance(x, y, z)));
  const auto input = openvdb::FloatGrid::create(2 * kSize);
  openvdb::tools::copyFromDense(dense, *input, 0.0F);
  openvdb::FloatGrid::Ptr output;
  for (auto _ : state) output = openvdb::tools::sdfToSdf(*input);
  auto accessor = output->getConstAccessor();
  reportError(state, [&](int x, int y, int z) { return accessor.getValue(openvdb::Coord(x, y, z)); });
}

BENCHMARK(isolumeDistance)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(isolumeDistanceAndOctants)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(openVdbFastSweeping)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace isolume

BENCHMARK_MAIN();
