#include "scene_textures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "clearance.h"
#include "gl_check.h"
#include "gpu_error.h"
#include "light_uniforms.h"
#include "sweep/half.h"
#include "sweep/parallel.h"
#include "textures.h"

namespace isolume {
namespace {

void checkSize(const char* what, glm::ivec3 size, glm::ivec3 expected) {
  if (size != expected) {
    throw GpuError(fmt::format("{}: expected {}x{}x{} samples as the level has, found {}x{}x{}", what, expected.x,
                               expected.y, expected.z, size.x, size.y, size.z));
  }
}

// Distances in units of the smallest spacing as half floats.
std::vector<std::uint16_t> packDistance(GridView<const float> distance) {
  std::vector<std::uint16_t> out(distance.count());
  const auto toUnits = static_cast<float>(1 / smallestSpacing(distance.spacing));
  const auto plane = static_cast<std::size_t>(distance.strideZ());
  parallelFor(static_cast<std::size_t>(distance.size.z), [&](std::size_t z) {
    const float* from = distance.data + z * plane;
    std::uint16_t* to = out.data() + z * plane;
    for (std::size_t i = 0; i < plane; ++i) to[i] = halfFromFloat(from[i] * toUnits);
  });
  return out;
}

// Samples and caps, some layers at a time.
GlTexture uploadField(const SurfaceField& field) {
  const glm::ivec3 size = field.paddedSize();
  constexpr std::size_t kStagingBytes = 4 << 20;  // less than a 16th of the texture at 256^3, and many calls' work
  const std::size_t layer = voxelCount({size.x, size.y, 1});
  const auto layers = static_cast<int>(
      std::clamp<std::size_t>(kStagingBytes / (layer * sizeof(std::uint16_t)), 1, static_cast<std::size_t>(size.z)));
  std::vector<std::uint16_t> staging(layer * static_cast<std::size_t>(layers));
  return makeTextureSlices("light", size, kR16, GL_NEAREST, layers, [&](int begin, int end) {
    field.copyLayers(begin, end, staging.data());
    return static_cast<const void*>(staging.data());
  });
}

}  // namespace

SceneTextures uploadScene(const SceneFields& fields) {
  const glm::ivec3 size = fields.level.size;
  if (!fields.level.data || size.x < 2 || size.y < 2 || size.z < 2) {
    throw GpuError(
        fmt::format("level: expected at least 2 samples along each axis, found {}x{}x{}", size.x, size.y, size.z));
  }
  SceneTextures scene;
  scene.size = size;
  scene.frame = makeGridFrame(fields.worldFromGrid);
  // The grid's own spacing is the matrix's up to rounding; lengths on the GPU go by the matrix.
  GridView<const float> level = fields.level, distance = fields.distance;
  level.spacing = distance.spacing = scene.frame.spacing;
  scene.level = makeTextureSlices("level", size, kR32F, GL_LINEAR, level.data);
  scene.clearance = makeTextureSlices("clearance", size - 1, kR8UI, GL_NEAREST, buildClearance(level).data());
  if (fields.distance.data) {
    checkSize("distance", fields.distance.size, size);
    scene.distance = makeTextureSlices("distance", size, kR16F, GL_LINEAR, packDistance(distance).data());
  }
  if (fields.octants[0].data) {
    for (std::size_t i = 0; i < scene.octants.size(); ++i) {
      checkSize("octants", fields.octants[i].size, size);
      scene.octants[i] = makeTexture3D("octants", size, kRGBA8, GL_NEAREST, fields.octants[i].data);
    }
  }
  if (fields.lights.size() > shader::kMostLightFields)
    throw GpuError(
        fmt::format("lights: expected at most {} fields, found {}", shader::kMostLightFields, fields.lights.size()));
  for (LightField field : fields.lights) {
    const SurfaceField& values = *std::exchange(field.values, nullptr);
    checkSize("light", values.size(), size);
    scene.lights.push_back(uploadField(values));
    scene.lightFields.push_back(field);
  }
  if (fields.color) scene.colors = SurfaceColors(*fields.color, fields.worldFromGrid);
  glFinish();
  checkGl("upload");
  return scene;
}

}  // namespace isolume
