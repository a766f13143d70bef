#include "gradient_noise.h"

#include <array>

#include "random.h"

namespace isolume {
namespace {

// The middles of a cube's edges, four of them twice to fill sixteen places, as in [Perlin02].
const std::array<glm::dvec3, 16> kGradients{
    glm::dvec3(1, 1, 0), {-1, 1, 0}, {1, -1, 0}, {-1, -1, 0}, {1, 0, 1}, {-1, 0, 1}, {1, 0, -1}, {-1, 0, -1},
    {0, 1, 1},           {0, -1, 1}, {0, 1, -1}, {0, -1, -1}, {1, 1, 0}, {-1, 1, 0}, {0, -1, 1}, {0, -1, -1}};

const glm::dvec3& latticeGradient(std::int64_t x, std::int64_t y, std::int64_t z, std::uint64_t seed) {
  // Odd 64-bit constants with no pattern, so that neighbouring lattice points get unrelated bits.
  const std::uint64_t key = static_cast<std::uint64_t>(x) * 0x8da6b343d8163841u +
                            static_cast<std::uint64_t>(y) * 0xcb1ab31f9e3779b9u +
                            static_cast<std::uint64_t>(z) * 0x165667b19e3779f9u + seed * 0x9e3779b97f4a7c15u;
  return kGradients[mixBits(key) >> 60];  // the best mixed bits are the upper ones
}

// 6 t^5 - 15 t^4 + 10 t^3: first and second derivatives vanish at 0 and 1.
glm::dvec3 fade(glm::dvec3 t) { return t * t * t * (t * (t * 6.0 - 15.0) + 10.0); }
glm::dvec3 fadeSlope(glm::dvec3 t) { return 30.0 * t * t * (t * (t - 2.0) + 1.0); }

struct Cell {
  std::array<std::int64_t, 3> corner;
  glm::dvec3 t;  // position in it, each coordinate in [0, 1)
};
std::int64_t floorOf(double x) {
  const auto truncated = static_cast<std::int64_t>(x);
  return truncated - (x < static_cast<double>(truncated) ? 1 : 0);
}
Cell cellOf(glm::dvec3 p) {
  const std::array<std::int64_t, 3> corner{floorOf(p.x), floorOf(p.y), floorOf(p.z)};
  return {corner, p - glm::dvec3(corner[0], corner[1], corner[2])};
}

// Calls visit(ramp, gradient, x, y, z) for each corner; ramp is the corner's linear function at t.
template <class Visit>
void forEachCorner(const Cell& cell, std::uint64_t seed, const Visit& visit) {
  for (int z = 0; z < 2; ++z)
    for (int y = 0; y < 2; ++y)
      for (int x = 0; x < 2; ++x) {
        const glm::dvec3& g = latticeGradient(cell.corner[0] + x, cell.corner[1] + y, cell.corner[2] + z, seed);
        visit(glm::dot(g, cell.t - glm::dvec3(x, y, z)), g, x, y, z);
      }
}

}  // namespace

double gradientNoiseValue(glm::dvec3 p, std::uint64_t seed) {
  const Cell cell = cellOf(p);
  const glm::dvec3 fade1 = fade(cell.t);
  const std::array<glm::dvec3, 2> weight{1.0 - fade1, fade1};
  double sum = 0;
  forEachCorner(cell, seed, [&](double ramp, const glm::dvec3&, int x, int y, int z) {
    sum += weight[x].x * weight[y].y * weight[z].z * ramp;
  });
  return sum;
}

NoiseSample gradientNoise(glm::dvec3 p, std::uint64_t seed) {
  const Cell cell = cellOf(p);
  const glm::dvec3 fade1 = fade(cell.t), slope1 = fadeSlope(cell.t);
  const std::array<glm::dvec3, 2> weight{1.0 - fade1, fade1}, slope{-slope1, slope1};
  NoiseSample sum;
  forEachCorner(cell, seed, [&](double ramp, const glm::dvec3& g, int x, int y, int z) {
    const double wx = weight[x].x, wy = weight[y].y, wz = weight[z].z;
    sum.value += wx * wy * wz * ramp;
    sum.gradient +=
        wx * wy * wz * g + ramp * glm::dvec3(slope[x].x * wy * wz, wx * slope[y].y * wz, wx * wy * slope[z].z);
  });
  return sum;
}

}  // namespace isolume
