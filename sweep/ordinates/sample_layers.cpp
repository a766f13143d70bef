#include "sample_layers.h"

namespace isolume {

SampleLayers layersOfSamples(const std::vector<NearSample>& samples, glm::ivec3 size, int axis) {
  const RayAxes axes = kRayAxes[static_cast<std::size_t>(axis)];
  SampleLayers layers;
  layers.begin.assign(static_cast<std::size_t>(size[axis]) + 1, 0);
  for (const NearSample& each : samples) ++layers.begin[static_cast<std::size_t>(each.at[axis]) + 1];
  for (std::size_t k = 1; k < layers.begin.size(); ++k) layers.begin[k] += layers.begin[k - 1];
  std::vector<std::uint32_t> next(layers.begin.begin(), layers.begin.end() - 1);
  layers.column.resize(samples.size());
  layers.row.resize(samples.size());
  layers.sample.resize(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::size_t to = next[static_cast<std::size_t>(samples[i].at[axis])]++;
    layers.column[to] = static_cast<std::uint16_t>(samples[i].at[axes.bit]);
    layers.row[to] = static_cast<std::uint16_t>(samples[i].at[axes.row]);
    layers.rows = unionOf(layers.rows, {samples[i].at[axes.row], samples[i].at[axes.row] + 1});
    layers.sample[to] = static_cast<std::uint32_t>(i);
  }
  return layers;
}

}  // namespace isolume
