#include "sweep/ordinates/solid_lattice.h"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "support/random_numbers.h"
#include "sweep/near_sets.h"

namespace isolume {
namespace {

bool bitOf(const BitRows& bits, int x, int r, int layer) { return (bits.row(r, layer)[x / 64] >> (x % 64) & 1) != 0; }

// Is the trilinear interpolant positive at point p of the lattice? In double, as the mean of the corners of p's cell
// with a corner on each side of p counted once per side; nothing where float arithmetic may see another sign.
std::optional<bool> interpolantIsSolid(GridView<const float> level, glm::ivec3 p, int refinement) {
  double sum = 0, size = 0;
  int count = 0;
  for (int corner = 0; corner < 8; ++corner) {
    glm::ivec3 sample(0);
    for (int axis = 0; axis < 3; ++axis) {
      const double along = static_cast<double>(p[axis]) / refinement;
      sample[axis] = static_cast<int>((corner >> axis & 1) != 0 ? std::ceil(along) : std::floor(along));
    }
    const double value = level(sample.x, sample.y, sample.z);
    sum += value;
    size += std::abs(value);
    count += value > 0 ? 1 : 0;
  }
  // Corners of one side need no arithmetic.
  if (count == 8 || count == 0) return count == 8;
  constexpr double kRounding = 0x1p-22;  // of the sum of magnitudes: 3 additions and a scaling, half an ulp each
  if (std::abs(sum) <= kRounding * size) return std::nullopt;
  return sum > 0;
}

// Noise with samples at 0 and of extreme size; `solidShare` of them solid, in clusters of `run` along x, so that whole
// words of one side occur.
Grid<float> roughLevel(glm::ivec3 size, double solidShare, int run, std::uint64_t seed) {
  Grid<float> level(size);
  test::RandomNumbers numbers(seed);
  double sign = -1;
  for (std::size_t i = 0; i < level.count(); ++i) {
    if (numbers.below(run) == 0) sign = numbers.uniform() < solidShare ? 1 : -1;
    const int kind = numbers.below(12);
    const double magnitude = kind == 0   ? 0
                             : kind == 1 ? 1e30
                             : kind == 2 ? 1e38
                             : kind == 3 ? 1e-30
                                         : numbers.uniform();
    level.data()[i] = static_cast<float>(sign * magnitude);
  }
  return level;
}

void expectInterpolant(GridView<const float> level, int refinement) {
  SCOPED_TRACE(testing::Message() << level.size.x << "x" << level.size.y << "x" << level.size.z << " by "
                                  << refinement);
  const SolidLattice lattice = makeSolidLattice(level, insideSamples(level), refinement);
  const glm::ivec3 n = lattice.size;
  ASSERT_EQ(n, (level.size - 1) * refinement + 1);
  for (int z = 0; z < n.z; ++z) {
    for (int y = 0; y < n.y; ++y) {
      for (int x = 0; x < lattice.alongX.words * 64; ++x) {
        const bool got = bitOf(lattice.alongX, x, y, z);
        const std::optional<bool> want = x < n.x ? interpolantIsSolid(level, {x, y, z}, refinement) : false;
        ASSERT_EQ(got, want.value_or(got)) << "alongX at " << x << " " << y << " " << z;
      }
    }
    for (int x = 0; x < n.x; ++x)
      for (int y = 0; y < lattice.alongY.words * 64; ++y)
        ASSERT_EQ(bitOf(lattice.alongY, y, x, z), y < n.y && bitOf(lattice.alongX, x, y, z))
            << "alongY at " << x << " " << y << " " << z;
  }
}

TEST(SolidLattice, BitsAreTheSignsOfTheInterpolant) {
  // Every bit in both orders is whether the interpolant is positive there, and 0 beyond the rows' ends: for rows that
  // just fill a word, fall one short or exceed it, and for noise as well as for whole words of one side.
  const glm::ivec3 sizes[] = {{1, 1, 1},  {1, 9, 2},  {9, 1, 3},   {2, 2, 2},  {31, 5, 2},  {32, 33, 3}, {33, 32, 2},
                              {63, 3, 4}, {64, 2, 3}, {65, 3, 2},  {5, 63, 2}, {3, 64, 2},  {4, 65, 2},  {64, 65, 2},
                              {70, 1, 1}, {1, 70, 1}, {1, 1, 70},  {70, 4, 3}, {128, 2, 2}, {130, 2, 3}, {257, 2, 1},
                              {64, 1, 1}, {1, 64, 1}, {128, 1, 2}, {256, 1, 1}};
  std::uint64_t seed = 0;
  for (const glm::ivec3& size : sizes)
    for (const double share : {0.0, 0.02, 0.5, 0.98, 1.0})
      for (const int run : {1, 100})
        for (const int refinement : {1, 2}) expectInterpolant(roughLevel(size, share, run, ++seed).view(), refinement);
}

TEST(SolidLattice, RandomSizesToo) {
  // The same for 60 grids of random size up to 70 samples along an axis.
  test::RandomNumbers numbers(5);
  for (int i = 0; i < 60; ++i) {
    glm::ivec3 size(1 + numbers.below(70), 1 + numbers.below(12), 1 + numbers.below(6));
    if (i % 3 == 1) std::swap(size.x, size.y);
    if (i % 3 == 2) std::swap(size.x, size.z);
    const Grid<float> level = roughLevel(size, numbers.uniform(), 1 + numbers.below(90), 100 + numbers.below(1000));
    for (const int refinement : {1, 2}) expectInterpolant(level.view(), refinement);
  }
}

}  // namespace
}  // namespace isolume
