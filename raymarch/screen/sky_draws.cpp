#include "raymarch/screen/sky_draws.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "sweep/ordinates/sky_ordinates.h"

namespace isolume {
namespace {

float luminanceOf(glm::vec3 radiance) { return glm::dot(radiance, glm::vec3(kLuminance)); }

struct CellTexel {
  std::size_t index;
  glm::ivec2 place;  ///< on its face
};

/// Place `index` of a Z-curve: its parts of equal length are blocks.
glm::ivec2 onCurve(int index) {
  glm::ivec2 place(0);
  for (int bit = 0; index >> (2 * bit) > 0; ++bit) {
    place.x |= (index >> (2 * bit) & 1) << bit;
    place.y |= (index >> (2 * bit + 1) & 1) << bit;
  }
  return place;
}

/// Along the curve, so that strata of the running power are compact.
std::vector<CellTexel> texelsOf(const SkyCube& sky, int face, glm::ivec2 cell) {
  const int width = sky.side / kCellsAlong;
  std::vector<CellTexel> texels;
  for (int i = 0; i < width * width; ++i) {
    const glm::ivec2 place = cell * width + onCurve(i);
    texels.push_back({static_cast<std::size_t>((face * sky.side + place.y) * sky.side + place.x), place});
  }
  return texels;
}

}  // namespace

std::vector<glm::vec4> skyDraws(const SkyCube& sky) {
  assert(std::has_single_bit(static_cast<unsigned>(sky.side / kCellsAlong)));
  const std::vector<double> angles = cubeSolidAngles(sky.side);
  std::vector<glm::vec4> table;
  for (int cell = 0; cell < kSkyCells; ++cell) {
    const int face = cell / (kCellsAlong * kCellsAlong);
    const glm::ivec2 place(cell % kCellsAlong, cell / kCellsAlong % kCellsAlong);
    const std::vector<CellTexel> texels = texelsOf(sky, face, place);
    std::vector<double> powerUpTo;
    double power = 0;
    for (const CellTexel& texel : texels)
      powerUpTo.push_back(power += angles[texel.index % angles.size()] * luminanceOf(sky.radiance[texel.index]));
    table.emplace_back(glm::vec3(cubeDirection(kCellsAlong, face, glm::dvec2(place) + 0.5)), power);
    for (int draw = 0; draw < kCellDraws; ++draw) {
      // Places within strata and texels by the golden ratio: no two cells have the same, so nothing lines up.
      const double count = cell * kCellDraws + draw + 0.5, share = std::fmod(count / std::numbers::phi, 1.0);
      const double target = (draw + share) / kCellDraws * power;
      const auto found = std::upper_bound(powerUpTo.begin(), powerUpTo.end() - 1, target) - powerUpTo.begin();
      const CellTexel& texel = texels[static_cast<std::size_t>(found)];
      const glm::dvec2 within(std::fmod(share * kCellDraws, 1.0), std::fmod(share * kCellDraws * kCellDraws, 1.0));
      const glm::vec3 radiance = sky.radiance[texel.index];
      const float luminance = luminanceOf(radiance);
      table.emplace_back(glm::vec3(cubeDirection(sky.side, face, glm::dvec2(texel.place) + within)), 0);
      table.emplace_back(luminance > 0 ? radiance / luminance : glm::vec3(0), 0);
    }
  }
  return table;
}

}  // namespace isolume
