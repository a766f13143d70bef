#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "volumes/gradient_noise.h"
#include "volumes/random.h"
#include "volumes/scene_families.h"
#include "volumes/scenes.h"

namespace isolume {
namespace {

using ::testing::ElementsAre;

double insideShare(GridView<const float> view) {
  std::size_t inside = 0;
  for (std::size_t i = 0; i < view.count(); ++i) inside += view.data[i] < 0;
  return static_cast<double>(inside) / static_cast<double>(view.count());
}

TEST(Scenes, NamesAreFound) {
  // Every listed name is found under that name and described; others are not.
  EXPECT_THAT(sceneNames(),
              ElementsAre("corner", "capillaries", "gyroid", "capsules", "spheres", "vorticity", "terrain"));
  for (const std::string_view name : sceneNames()) {
    ASSERT_NE(findScene(name), nullptr);
    EXPECT_EQ(findScene(name)->name, name);
    EXPECT_FALSE(findScene(name)->description.empty());
  }
  EXPECT_EQ(findScene("Corner"), nullptr);
  EXPECT_EQ(findScene(""), nullptr);
}

TEST(Scenes, HaveInsideAndOutside) {
  // Every scene has a solid and open space, and every sample is finite.
  for (const std::string_view name : sceneNames()) {
    const Grid<float> grid = sampleScene(*findScene(name), 48);
    const double share = insideShare(grid.view());
    EXPECT_GT(share, 0.01) << name;
    EXPECT_LT(share, 0.5) << name;
    for (std::size_t i = 0; i < grid.count(); ++i) ASSERT_TRUE(std::isfinite(grid.data()[i])) << name;
  }
}

TEST(Scenes, RandomNumbersAreThoseOfSplitMix64) {
  // The first outputs for state 0 are the published ones, so every machine grows the same scenes.
  constexpr std::uint64_t kIncrement = 0x9e3779b97f4a7c15u;
  EXPECT_EQ(mixBits(kIncrement), 0xe220a8397b1dcdafu);
  EXPECT_EQ(mixBits(2 * kIncrement), 0x6e789e6aa1b965f4u);
  Random random(0);
  EXPECT_EQ(random.uniform(), static_cast<double>(0xe220a8397b1dcdafu >> 11) / 9007199254740992.0);  // 2^53
}

TEST(Scenes, CornerStandsBehindItsSolids) {
  // Floor and both walls are .12 thick, at -z, -x and +y; the opposite sides are open; the solids stand apart.
  EXPECT_NEAR(cornerValue({0.5, 0.02, 0.17}), 0.05, 1e-12);  // above the floor, near the front
  EXPECT_NEAR(cornerValue({0.17, 0.1, 0.9}), 0.05, 1e-12);   // beside the left wall
  EXPECT_NEAR(cornerValue({0.9, 0.83, 0.9}), 0.05, 1e-12);   // before the back wall
  EXPECT_GT(cornerValue({0.999, 0.3, 0.9}), 0.2);
  EXPECT_GT(cornerValue({0.6, 0.001, 0.9}), 0.2);
  EXPECT_NEAR(cornerValue({0.38, 0.34, 0.25}), -0.13, 1e-12);  // the sphere's centre
  EXPECT_NEAR(cornerValue({0.38, 0.34, 0.42}), 0.04, 1e-12);   // above the sphere, whose top is at .38
  EXPECT_NEAR(cornerValue({0.30, 0.68, 0.88}), 0.04, 1e-12);   // above the column, whose top is at .84
  EXPECT_NEAR(cornerValue({0.70, 0.64, 0.50}), 0.08, 1e-12);   // above the box, whose top is at .42
  EXPECT_GT(cornerValue({0.74, 0.26, 0.12 + 0.0728}), 0.05);   // the hole of the torus
}

TEST(Scenes, CapsulesAreAsDescribed) {
  // 60 capsules of radius .018 and lengths .2 to .5, all within the cube.
  EXPECT_EQ(capsulesPrimitives().size(), 60u);
  for (const TaperedCapsule& capsule : capsulesPrimitives()) {
    EXPECT_EQ(capsule.radiusA, 0.018);
    EXPECT_EQ(capsule.radiusB, 0.018);
    const double length = glm::length(capsule.b - capsule.a);
    EXPECT_GE(length, 0.2 - 1e-12);
    EXPECT_LE(length, 0.5 + 1e-12);
    for (const glm::dvec3 end : {capsule.a, capsule.b})
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_GT(end[axis], 0.018);
        EXPECT_LT(end[axis], 1 - 0.018);
      }
  }
}

TEST(Scenes, SpheresArePacked) {
  // No two spheres touch, none reaches the border, there are five sizes, and they fill the share that is theirs.
  const std::vector<Sphere>& spheres = spheresPrimitives();
  std::set<double> sizes;
  double volume = 0;
  for (std::size_t i = 0; i < spheres.size(); ++i) {
    sizes.insert(spheres[i].radius);
    volume += 4.0 / 3 * std::numbers::pi * std::pow(spheres[i].radius, 3);
    for (int axis = 0; axis < 3; ++axis) EXPECT_GT(0.5 - std::abs(spheres[i].center[axis] - 0.5), spheres[i].radius);
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GT(glm::length(spheres[i].center - spheres[j].center), spheres[i].radius + spheres[j].radius);
  }
  EXPECT_EQ(sizes.size(), 5u);
  // Sampling n cells of which a share s straddles a surface errs by about sqrt(s / n): 2e-4 at 100^3; ten times that.
  EXPECT_NEAR(insideShare(sampleScene(*findScene("spheres"), 100).view()), volume, 2e-3);
}

TEST(Scenes, GyroidHasItsSymmetries) {
  // Cyclic exchange of the axes and inversion in the centre change nothing but rounding; sheet and ball are where they
  // belong.
  Random random(5);
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 p = random.inBox(0, 1);
    EXPECT_NEAR(gyroidValue(p), gyroidValue({p.y, p.z, p.x}), 1e-14);
    EXPECT_NEAR(gyroidValue(p), gyroidValue(glm::dvec3(1) - p), 1e-14);
  }
  EXPECT_LT(gyroidValue({0.5, 0.5, 0.5}), 0);     // g = 0: the middle of the sheet
  EXPECT_GT(gyroidValue({0.5, 0.5, 0.9201}), 0);  // outside the ball
  // g = sin(pi/2) = 1 a twelfth of the cube from the centre, along x: between the sheets by 1/2 over the wave number.
  EXPECT_NEAR(gyroidValue({0.5 + 1.0 / 12, 0.5, 0.5}), 0.5 / (6 * std::numbers::pi), 1e-12);
}

// Size of the 26-connected component of the first sample inside.
std::size_t firstComponent(GridView<const float> view) {
  std::vector<char> seen(view.count(), 0);
  std::vector<glm::ivec3> stack;
  for (int i = 0; stack.empty() && i < static_cast<int>(view.count()); ++i)
    if (view.data[i] < 0)
      stack.emplace_back(i % view.size.x, i / view.size.x % view.size.y, i / view.size.x / view.size.y);
  std::size_t count = stack.size();
  if (count) seen[view.index(stack[0].x, stack[0].y, stack[0].z)] = 1;
  while (!stack.empty()) {
    const glm::ivec3 c = stack.back();
    stack.pop_back();
    for (int n = 0; n < 27; ++n) {
      const glm::ivec3 q = c + glm::ivec3(n % 3, n / 3 % 3, n / 9) - 1;
      if (glm::any(glm::lessThan(q, glm::ivec3(0))) || glm::any(glm::greaterThanEqual(q, view.size))) continue;
      const std::size_t i = view.index(q.x, q.y, q.z);
      if (seen[i] || view.data[i] >= 0) continue;
      seen[i] = 1;
      stack.push_back(q);
      ++count;
    }
  }
  return count;
}

TEST(Scenes, CapillariesAreOneThinTree) {
  // At 128^3 all samples inside hang together and fill between 2 and 6 percent, as the mouse brain's capillaries do.
  const Grid<float> grid = sampleScene(*findScene("capillaries"), 128);
  const double share = insideShare(grid.view());
  EXPECT_GT(share, 0.02);
  EXPECT_LT(share, 0.06);
  EXPECT_EQ(firstComponent(grid.view()),
            static_cast<std::size_t>(std::lround(share * static_cast<double>(grid.count()))));
}

TEST(Scenes, CapillariesBranchAndNarrow) {
  // Pieces join end to end with equal radii; there are many branchings and ends; radii span a factor of two and more.
  const std::vector<TaperedCapsule>& pieces = capillariesPrimitives();
  const auto key = [](glm::dvec3 p) { return std::array{p.x, p.y, p.z}; };
  std::map<std::array<double, 3>, int> children;
  std::map<std::array<double, 3>, double> radius;
  double thinnest = 1, thickest = 0;
  for (const TaperedCapsule& piece : pieces) {
    ++children[key(piece.a)];
    for (const auto& [point, r] : {std::pair{piece.a, piece.radiusA}, std::pair{piece.b, piece.radiusB}}) {
      EXPECT_EQ(radius.try_emplace(key(point), r).first->second, r);
      thinnest = std::min(thinnest, r);
      thickest = std::max(thickest, r);
    }
  }
  EXPECT_EQ(radius.size(), pieces.size() + 1);  // a tree: one node more than pieces
  const auto branchings = std::count_if(children.begin(), children.end(), [](const auto& c) { return c.second > 1; });
  EXPECT_GT(branchings, 200);
  EXPECT_GT(radius.size() - children.size(), 200u);  // ends
  EXPECT_GT(thickest, 2 * thinnest);
}

TEST(Scenes, NoiseGradientIsItsDerivative) {
  // The analytic gradient agrees with central differences, the two functions with each other, and lattice points give
  // 0.
  Random random(6);
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 p = random.inBox(-3, 3);
    const NoiseSample noise = gradientNoise(p, 42);
    EXPECT_NEAR(noise.value, gradientNoiseValue(p, 42), 1e-15);
    EXPECT_LE(std::abs(noise.value), 1);
    constexpr double h = 1e-5;  // third derivatives, up to 100, times h^2 stay below 1e-7
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 step(0);
      step[axis] = h;
      EXPECT_NEAR(noise.gradient[axis], (gradientNoiseValue(p + step, 42) - gradientNoiseValue(p - step, 42)) / (2 * h),
                  1e-7);
    }
  }
  EXPECT_EQ(gradientNoiseValue({-2, 0, 5}, 42), 0);
}

TEST(Scenes, VorticityHasNoDivergence) {
  // The field is a curl: its divergence vanishes where its derivatives do not.
  Random random(7);
  int strong = 0;
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec3 p = random.inBox(0.1, 0.9);
    constexpr double h = 1e-5;
    glm::dmat3 jacobian;  // columns: derivatives along x, y, z
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 step(0);
      step[axis] = h;
      jacobian[axis] = (vorticity(p + step) - vorticity(p - step)) / (2 * h);
    }
    const double scale = glm::length(jacobian[0]) + glm::length(jacobian[1]) + glm::length(jacobian[2]);
    if (scale < 100) continue;  // less than a tenth of what tubes show
    ++strong;
    // Central differences err by h^2 f''' / 6: with features of .01 at the finest, 1e-6 of the first derivatives.
    EXPECT_LT(std::abs(jacobian[0][0] + jacobian[1][1] + jacobian[2][2]), 1e-4 * scale);
  }
  EXPECT_GT(strong, 500);
}

TEST(Scenes, VorticityEndsBeforeTheBorder) {
  // The faces of the cube lie outside the solid: tubes close instead of being cut.
  for (int i = 0; i <= 100; ++i)
    for (int j = 0; j <= 100; ++j)
      for (int axis = 0; axis < 3; ++axis)
        for (const double side : {0.0, 1.0}) {
          glm::dvec3 p(i / 100.0, j / 100.0, side);
          std::swap(p.z, p[axis]);
          ASSERT_GT(vorticityValue(p), 0);
        }
}

TEST(Terrain, IsAHeightField) {
  // Each column is solid up to one height and open above it, which lies within the cube and is that of the function; no
  // slope along an axis is steeper than 1.6, so a camera from above sees everything.
  constexpr int kSide = 64;
  constexpr double kMostSlope = 1.6;
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      const double x = (i + 0.5) / kSide, y = (j + 0.5) / kSide, height = terrainHeight(x, y);
      ASSERT_GT(height, 0.1);
      ASSERT_LT(height, 0.7);
      for (int k = 0; k < kSide; ++k) {
        const double z = (k + 0.5) / kSide;
        ASSERT_EQ(terrainValue({x, y, z}) < 0, z < height);
      }
      ASSERT_LT(std::abs(terrainHeight(x + 1e-4, y) - height) / 1e-4, kMostSlope);
      ASSERT_LT(std::abs(terrainHeight(x, y + 1e-4) - height) / 1e-4, kMostSlope);
    }
  }
}

}  // namespace
}  // namespace isolume
