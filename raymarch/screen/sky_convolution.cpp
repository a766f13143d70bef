#include "raymarch/screen/sky_convolution.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "sweep/parallel.h"

namespace isolume {
namespace {

struct SkyTexel {
  glm::vec3 direction;
  glm::vec3 light;  ///< radiance times solid angle
  float angle;      ///< solid angle
};

std::vector<SkyTexel> texelsOf(const SkyCube& sky) {
  const std::vector<double> angles = cubeSolidAngles(sky.side);
  std::vector<SkyTexel> texels;
  for (std::size_t i = 0; i < sky.radiance.size(); ++i) {
    const auto angle = static_cast<float>(angles[i % angles.size()]);
    texels.push_back({glm::vec3(cubeTexelDirection(sky.side, i)), angle * sky.radiance[i], angle});
  }
  return texels;
}

}  // namespace

double coneAngle(int k) { return (k + 1) * std::numbers::pi / 2 / kConeAngles; }

std::vector<std::vector<glm::vec3>> convolvedSky(const SkyCube& sky, int first) {
  assert(first >= 0 && first < kConeAngles);
  SkyCube coarse = sky;
  while (coarse.side > kConeSide) coarse = halvedSky(coarse);
  const std::vector<SkyTexel> texels = texelsOf(coarse);
  // The share of a texel within a cone rises from 0 to 1 over its width.
  std::array<float, kConeAngles> cosine{}, rise{};
  for (std::size_t k = 0; k < cosine.size(); ++k) {
    const double angle = coneAngle(static_cast<int>(k)), width = std::numbers::pi / 2 / kConeSide;
    cosine[k] = static_cast<float>(std::cos(angle));
    rise[k] = static_cast<float>(1 / (std::sin(angle) * width));
  }
  std::vector<std::vector<glm::vec3>> cubes(static_cast<std::size_t>(kConeAngles - first),
                                            std::vector<glm::vec3>(texels.size()));
  parallelFor(texels.size(), [&](std::size_t i) {
    std::array<glm::vec3, kConeAngles> light{};
    std::array<float, kConeAngles> whole{};
    for (const SkyTexel& texel : texels) {
      const float facing = glm::dot(texels[i].direction, texel.direction);
      if (facing <= 0) continue;
      for (int k = kConeAngles - 1; k >= first; --k) {
        const auto at = static_cast<std::size_t>(k);
        const float share = std::min(0.5F + (facing - cosine[at]) * rise[at], 1.0F);
        if (share <= 0) break;  // nor within narrower ones
        light[at] += share * facing * texel.light;
        whole[at] += share * facing * texel.angle;
      }
    }
    for (std::size_t k = 0; k < cubes.size(); ++k) {
      const std::size_t at = k + static_cast<std::size_t>(first);
      cubes[k][i] = light[at] / whole[at];
    }
  });
  return cubes;
}

}  // namespace isolume
