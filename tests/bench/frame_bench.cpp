// A further frame at 1024^2 of the 256^3 gyroid, after upload and compilation, on the default backend, in
// the memory of the frame before.
//
// Held fixed: scene, camera (default framing), picture size. `openness` reads a light field, `relit` the same after its
// colour changed, `octants` eight octants, `local` nothing; `layers` adds the G-buffer read-back, `samples4` is four
// passes. Beside the time: the share of pixels that hit, as a check that the picture is there.
#include <benchmark/benchmark.h>

#include <memory>
#include <utility>

#include "raymarch/renderer.h"
#include "sweep/level.h"
#include "sweep/occlusion_sweep.h"
#include "sweep/ordinates/openness_sweep.h"
#include "volumes/scenes.h"

namespace isolume {
namespace {

constexpr int kSize = 256;

struct Bench {
  std::unique_ptr<Context> context = makeContext();
  Renderer renderer{*context};
  Camera camera;
  Bench() {
    Grid<float> level = sampleScene(*findScene("gyroid"), kSize);
    makeLevel(level.view(), 0, Inside::below);
    const SweptFields swept = sweepOcclusion(level.view());
    SceneFields fields;
    fields.worldFromGrid = glm::dmat4(1.0 / kSize);
    fields.worldFromGrid[3][3] = 1;
    fields.level = level.view();
    for (std::size_t i = 0; i < 2; ++i) fields.octants[i] = swept.visibility.packed[i].view();
    const SurfaceField openness = sweepOpenness(level.view(), swept.distance.view(), {.ordinates = 64});
    fields.lights = {{&openness}};
    renderer.upload(fields);
    camera = frameCorners(boxCorners(fields.worldFromGrid, glm::dvec3(20), glm::dvec3(kSize - 21)), 1, {});
  }
};

void frame(benchmark::State& state, RenderSettings settings) {
  static Bench bench;
  settings.occlusionOffsetVoxels = 2;
  settings.background = glm::vec4(0);
  Frame picture = bench.renderer.render(bench.camera, settings);  // compiles
  for (auto _ : state) picture = bench.renderer.render(bench.camera, settings, std::move(picture));
  double hits = 0;
  for (const glm::vec4& color : picture.color) hits += color.a;
  state.counters["hit_share"] = hits / static_cast<double>(picture.color.size());
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(picture.color.size()));
}

BENCHMARK_CAPTURE(frame, openness, RenderSettings{.shading = Shading::lights})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(frame, relit, RenderSettings{.shading = Shading::lights, .lightColors = {{1.0F, 0.5F, 0.25F}}})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(frame, octants, RenderSettings{})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(frame, local, RenderSettings{.shading = Shading::local})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();
BENCHMARK_CAPTURE(frame, layers, RenderSettings{.layers = true})->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK_CAPTURE(frame, samples4, RenderSettings{.samples = 4})->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace
}  // namespace isolume

BENCHMARK_MAIN();
