// Octant visibility: bounds, closed forms, symmetry, and the bias of the faithful mode, stated as numbers.
#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <vector>

#include "support/octant_openness.h"
#include "support/plain_light.h"
#include "support/simd_targets.h"
#include "support/test_levels.h"
#include "sweep/closest/closest_distance.h"
#include "sweep/occlusion_sweep.h"

namespace isolume {
namespace {

using test::noiseLevel;
using test::octantOpenness;
using test::sampleLevel;

const SweepOptions kFloatOctants{.visibility = VisibilityStorage::float32};

TEST(Visibility, LiesInZeroToOneOnNoise) {
  // V is a weighted mean of what the neighbours let through: never outside [0, 1], whatever the data.
  for (const glm::dvec3& spacing : {glm::dvec3(1), glm::dvec3(0.3, 1.7, 0.9)}) {
    const Grid<float> level = noiseLevel({40, 33, 37}, spacing, 21);
    const SweptFields fields = sweepOcclusion(level.view(), kFloatOctants);
    for (const Grid<float>& octant : fields.visibility.octants) {
      for (std::size_t i = 0; i < octant.count(); ++i) {
        ASSERT_GE(octant.data()[i], 0);
        ASSERT_LE(octant.data()[i], 1);
      }
    }
  }
}

TEST(Visibility, OfAnEmptyGridIsExactlyOne) {
  // Without a solid all light arrives, to the last bit, however far the sweep runs and whatever the weights are.
  for (const glm::dvec3& spacing : {glm::dvec3(1), glm::dvec3(0.957, 0.957, 1.5), glm::dvec3(7, 0.1, 2.2)}) {
    const auto level = sampleLevel({150, 70, 60}, spacing, [](glm::dvec3) { return -1.0; });
    const SweptFields fields = sweepOcclusion(level.view(), kFloatOctants);
    for (const Grid<float>& octant : fields.visibility.octants) {
      EXPECT_EQ(*std::min_element(octant.data(), octant.data() + octant.count()), 1.0F);
      EXPECT_EQ(*std::max_element(octant.data(), octant.data() + octant.count()), 1.0F);
    }
  }
}

TEST(Visibility, MirroredScenesAreMirroredBitForBit) {
  // Mirroring the data along any axes mirrors octant s into the octant with those signs flipped, to the last bit.
  const glm::ivec3 n(37, 26, 31);
  const Grid<float> level = noiseLevel(n, {1, 1.5, 0.8}, 33);
  const SweptFields fields = sweepOcclusion(level.view(), kFloatOctants);
  for (int mirror = 1; mirror < 8; ++mirror) {
    const auto flip = [&](glm::ivec3 p) {
      for (int axis = 0; axis < 3; ++axis)
        if ((mirror >> axis & 1) != 0) p[axis] = n[axis] - 1 - p[axis];
      return p;
    };
    Grid<float> mirrored(n, {1, 1.5, 0.8});
    for (int z = 0; z < n.z; ++z)
      for (int y = 0; y < n.y; ++y)
        for (int x = 0; x < n.x; ++x) {
          const glm::ivec3 q = flip({x, y, z});
          mirrored.view()(x, y, z) = level.view()(q.x, q.y, q.z);
        }
    const SweptFields other = sweepOcclusion(mirrored.view(), kFloatOctants);
    for (std::size_t s = 0; s < kOctants.size(); ++s) {
      const std::size_t t = s ^ static_cast<std::size_t>(mirror);  // bit k of an octant's index is the sign of axis k
      for (int z = 0; z < n.z; ++z)
        for (int y = 0; y < n.y; ++y)
          for (int x = 0; x < n.x; ++x) {
            const glm::ivec3 q = flip({x, y, z});
            ASSERT_EQ(other.visibility.octants[s].view()(x, y, z), fields.visibility.octants[t].view()(q.x, q.y, q.z));
          }
    }
  }
}

TEST(Visibility, ThroughAClearSolidIsExactlyOne) {
  // At opacity 0 all light arrives everywhere, to the last bit, swept with the distance and through it.
  for (const glm::dvec3& spacing : {glm::dvec3(1), glm::dvec3(0.957, 0.957, 1.5)}) {
    const Grid<float> level = noiseLevel({70, 33, 37}, spacing, 22);
    const SweptFields fields = sweepOcclusion(level.view(), {.visibility = VisibilityStorage::float32, .opacity = 0});
    const OctantVisibility alone =
        sweepVisibility(std::as_const(fields.distance).view(), VisibilityStorage::float32, 0);
    for (std::size_t s = 0; s < kOctants.size(); ++s)
      for (std::size_t i = 0; i < level.count(); ++i) {
        ASSERT_EQ(fields.visibility.octants[s].data()[i], 1.0F);
        ASSERT_EQ(alone.octants[s].data()[i], 1.0F);
      }
  }
}

TEST(Visibility, EmptySpaceAroundATranslucentSolidIsExactlyOne) {
  // Whatever the opacity, light that meets no voxel of the surface arrives undimmed, to the last bit.
  for (const float opacity : {1e-9F, 1e-4F, 0.1F, 0.3F, 0.77F, 1.0F}) {
    const auto level = sampleLevel({40, 20, 30}, glm::dvec3(1), [](glm::dvec3 p) { return 7.0 - p.z; });
    const SweptFields fields =
        sweepOcclusion(level.view(), {.visibility = VisibilityStorage::float32, .opacity = opacity});
    for (std::size_t s = 0; s < kOctants.size(); ++s) {
      if (kOctants[s].towardsLight().z < 0) continue;
      EXPECT_EQ(fields.visibility.octants[s].view()(20, 10, 12), 1.0F) << opacity;
    }
  }
}

TEST(Visibility, FallsOffInATranslucentSolidAsEq8Says) {
  // Deep in a solid each voxel lets 1 - alpha pass: away from the border V of a layer is (1 - alpha) (2 V + V above) /
  // 3, so that it falls by the factor t / (3 - 2 t), t = 1 - alpha, per layer. Light through the thin far side is seen.
  const auto level = sampleLevel({90, 90, 24}, glm::dvec3(1), [](glm::dvec3 p) { return 20.0 - p.z; });
  for (const float opacity : {0.05F, 0.3F, 0.9F}) {
    const double t = 1 - static_cast<double>(opacity), factor = t / (3 - 2 * t);
    const SweptFields fields =
        sweepOcclusion(level.view(), {.visibility = VisibilityStorage::float32, .opacity = opacity});
    for (std::size_t s = 0; s < kOctants.size(); ++s) {
      if (kOctants[s].towardsLight().z < 0) continue;
      const auto v = fields.visibility.octants[s].view();
      for (int z = 14; z < 18; ++z) EXPECT_NEAR(v(45, 45, z), factor * v(45, 45, z + 1), 1e-5) << opacity;
      EXPECT_GT(v(45, 45, 17), 0);
    }
  }
}

TEST(Visibility, BehindAWallIsZeroAndInFrontIsOne) {
  // A thick slab across z: light from above does not pass, light from above reaches everything above undimmed.
  const auto level = sampleLevel({30, 30, 30}, glm::dvec3(1), [](glm::dvec3 p) { return 4.0 - std::abs(p.z - 15.0); });
  const SweptFields fields = sweepOcclusion(level.view(), kFloatOctants);
  for (std::size_t s = 0; s < kOctants.size(); ++s) {
    const bool fromAbove = kOctants[s].towardsLight().z > 0;
    const auto& v = fields.visibility.octants[s];
    // At the middle of the slab's shadow no side light is left: the border is 15 voxels away, the shadow 8 deep.
    EXPECT_EQ(v.view()(15, 15, fromAbove ? 22 : 8), 1.0F);
    EXPECT_EQ(v.view()(15, 15, fromAbove ? 13 : 17), 0.0F);
  }
}

TEST(Visibility, OnAnAxisAlignedFloorHasTheClosedFormOfEq6And7) {
  // A sample at height z0 in [0, h/2) above a floor sees tau = z0/h + 1/2 in its own plane, so that octants from above
  // obey V = (1 + 2 tau V) / 3 away from the border: V = 1 / (3 - 2 tau). This is the paper's self-occlusion.
  for (const double height : {0.0, 0.1, 0.25, 0.4}) {
    const auto level = sampleLevel({80, 80, 20}, glm::dvec3(1), [&](glm::dvec3 p) { return 9.0 - height - p.z; });
    const SweptFields fields = sweepOcclusion(level.view(), kFloatOctants);
    const double tau = height + 0.5;
    for (std::size_t s = 0; s < kOctants.size(); ++s) {
      if (kOctants[s].towardsLight().z < 0) continue;
      EXPECT_NEAR(fields.visibility.octants[s].view()(40, 40, 9), 1 / (3 - 2 * tau), 1e-5) << height;
    }
  }
}

struct Bias {
  double mean = 0, lowest = 1, highest = 0;
};

// Open planes through the middle of a grid at 200 tilts (Fibonacci lattice); A is read `offset` voxels above them.
Bias planeBias(double offset) {
  constexpr int kTilts = 200;
  constexpr int kSize = 40;
  const glm::dvec3 centre(19.4, 19.7, 19.55);
  Bias bias;
  for (int i = 0; i < kTilts; ++i) {
    const double z = 1 - 2 * (i + 0.5) / kTilts;
    const double angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
    const double r = std::sqrt(1 - z * z);
    const glm::dvec3 normal(r * std::cos(angle), r * std::sin(angle), z);
    const auto level =
        sampleLevel(glm::ivec3(kSize), glm::dvec3(1), [&](glm::dvec3 p) { return glm::dot(centre - p, normal); });
    const SweptFields fields = sweepOcclusion(level.view(), kFloatOctants);
    const double a = octantOpenness(fields.visibility, centre + offset * normal, normal);
    bias.mean += a / kTilts;
    bias.lowest = std::min(bias.lowest, a);
    bias.highest = std::max(bias.highest, a);
  }
  return bias;
}

TEST(Visibility, FaithfulModeDarkensAnOpenPlaneByItsDocumentedBias) {
  // As written in the paper, an open plane (truth: A = 1) occludes itself: A = .56 on average over all tilts when read
  // at the hit, never lighter than .62; two voxels above the plane, outside of its ramp, .90.
  const Bias atHit = planeBias(0);
  EXPECT_NEAR(atHit.mean, 0.558, 0.01);
  EXPECT_GT(atHit.lowest, 0.52);
  EXPECT_LT(atHit.highest, 0.62);
  const Bias above = planeBias(2);
  EXPECT_NEAR(above.mean, 0.904, 0.01);
}

// [Singh10] Eq. 6 to 8 through given distances, in plain loops: light enters at the border.
std::vector<double> plainVisibility(GridView<const float> distance, glm::ivec3 sign, double opacity) {
  const glm::ivec3 n = distance.size;
  const double smallest = smallestSpacing(distance.spacing);
  const glm::dvec3 weight =
      (1.0 / distance.spacing) / (1 / distance.spacing.x + 1 / distance.spacing.y + 1 / distance.spacing.z);
  std::vector<double> visibility(distance.count());
  for (int k = 0; k < n.z; ++k)
    for (int j = 0; j < n.y; ++j)
      for (int i = 0; i < n.x; ++i) {
        const glm::ivec3 p(sign.x > 0 ? i : n.x - 1 - i, sign.y > 0 ? j : n.y - 1 - j, sign.z > 0 ? k : n.z - 1 - k);
        double sum = 0;
        for (int axis = 0; axis < 3; ++axis) {
          glm::ivec3 q = p;
          q[axis] -= sign[axis];
          const bool within = q[axis] >= 0 && q[axis] < n[axis];
          double light = 1;
          if (within) {
            const double tau = std::clamp(distance(q.x, q.y, q.z) / smallest + 0.5, 0.0, 1.0);
            light = (1 - (1 - tau) * opacity) * visibility[distance.index(q.x, q.y, q.z)];
          }
          sum += weight[axis] * light;
        }
        visibility[distance.index(p.x, p.y, p.z)] = sum;
      }
  return visibility;
}

TEST(Visibility, AloneItIsEquationSixThroughTheGivenDistances) {
  // With distances from anywhere, here random ones, V is the plain recursion of any opacity; distances are not changed
  // by the sweep. A ray of 90 steps gathers 90 roundings of 2^-24 for each of its few operations.
  constexpr double kRounding = 3e-5;
  for (const glm::dvec3& spacing : {glm::dvec3(1), glm::dvec3(0.4, 1.1, 0.7)}) {
    Grid<float> distance = noiseLevel({31, 26, 37}, spacing, 8);
    for (std::size_t i = 0; i < distance.count(); ++i) distance.data()[i] += 0.4F;  // more open than not
    for (const float opacity : {1.0F, 0.6F, 0.1F}) {
      const OctantVisibility swept = sweepVisibility(distance.view(), VisibilityStorage::float32, opacity);
      double least = 1;
      for (std::size_t s = 0; s < kOctants.size(); ++s) {
        const std::vector<double> plain = plainVisibility(distance.view(), kOctants[s].sweep, opacity);
        for (std::size_t i = 0; i < plain.size(); ++i) {
          ASSERT_NEAR(swept.octants[s].data()[i], plain[i], kRounding) << "octant " << s;
          least = std::min(least, plain[i]);
        }
      }
      EXPECT_LT(least, 1 - opacity / 2);
    }
  }
}

TEST(Visibility, AloneItHasTheBitsOfPlainLoopsOnEveryInstructionSet) {
  // Light alone through given distances, infinite ones too, equals plain loops bit for bit, for any size, spacing
  // and opacity.
  const int tried = test::onEverySimdTarget([] {
    for (const glm::ivec3& size : {glm::ivec3(1, 1, 1), glm::ivec3(3, 40, 9), glm::ivec3(53, 37, 22)})
      for (const glm::dvec3& spacing : {glm::dvec3(1), glm::dvec3(0.3, 1.1, 0.7), glm::dvec3(1e-6, 2e-6, 1e-6)}) {
        Grid<float> distance = noiseLevel(size, spacing, 18);
        for (std::size_t i = 0; i < distance.count(); ++i) {
          float& value = distance.data()[i];
          value = (value + 0.4F) * static_cast<float>(spacing.x);
          if (i % 50 == 7) value = std::copysign(std::numeric_limits<float>::infinity(), value);
        }
        for (const float opacity : {1.0F, 0.35F}) {
          const OctantVisibility swept = sweepVisibility(distance.view(), VisibilityStorage::float32, opacity);
          for (std::size_t s = 0; s < kOctants.size(); ++s) {
            const std::vector<float> plain = test::plainLight(distance.view(), kOctants[s].sweep, opacity);
            EXPECT_EQ(std::memcmp(swept.octants[s].data(), plain.data(), plain.size() * sizeof(float)), 0)
                << "octant " << s;
          }
        }
      }
  });
  EXPECT_GE(tried, 1);
}

TEST(Visibility, WithClosestPointsGoesThroughTheirDistances) {
  // sweepOcclusion by the other solver is that solver's distance, to the last bit, and the visibility through it.
  const Grid<float> level = noiseLevel({29, 24, 33}, {1, 1, 1.5}, 5);
  const SweptFields fields =
      sweepOcclusion(level.view(), {.visibility = VisibilityStorage::rgba8, .solver = DistanceSolver::closest});
  const Grid<float> distance = closestDistance(level.view());
  const OctantVisibility visibility = sweepVisibility(distance.view(), VisibilityStorage::rgba8);
  EXPECT_EQ(std::memcmp(fields.distance.data(), distance.data(), distance.count() * sizeof(float)), 0);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_EQ(std::memcmp(fields.visibility.packed[i].data(), visibility.packed[i].data(), 4 * distance.count()), 0);
}

}  // namespace
}  // namespace isolume
