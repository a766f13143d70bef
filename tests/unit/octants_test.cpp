#include "sweep/octants.h"

#include <gtest/gtest.h>

#include <set>
#include <tuple>

namespace isolume {
namespace {

TEST(Octants, TableIsTable1OfThePaper) {
  // The eight sweeps are those of [Singh10] Table 1, in its order.
  const glm::ivec3 expected[8] = {{1, 1, 1},  {-1, 1, 1},  {1, -1, 1},  {-1, -1, 1},
                                  {1, 1, -1}, {-1, 1, -1}, {1, -1, -1}, {-1, -1, -1}};
  for (std::size_t s = 0; s < 8; ++s) EXPECT_EQ(kOctants[s].sweep, expected[s]) << "sweep " << s + 1;
}

TEST(Octants, LightComesFromTheOppositeOctantAndTheNameSaysWhich) {
  // Each octant's name spells the signs of the directions towards its light, and no two are alike.
  std::set<std::string_view> names;
  for (const Octant& octant : kOctants) {
    EXPECT_EQ(octant.towardsLight(), -octant.sweep);
    ASSERT_EQ(octant.name.size(), 3U);
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(octant.name[static_cast<std::size_t>(axis)], octant.towardsLight()[axis] > 0 ? 'p' : 'n');
    }
    names.insert(octant.name);
  }
  EXPECT_EQ(names.size(), 8U);
}

TEST(Octants, TheTwoTexturesMirrorEachOtherInZ) {
  // Octants s and s + 4 differ in the sign of z only: the shader swaps the two tables for normals that point down.
  for (std::size_t s = 0; s < 4; ++s) {
    EXPECT_EQ(kOctants[s + 4].sweep, kOctants[s].sweep * glm::ivec3(1, 1, -1));
  }
}

}  // namespace
}  // namespace isolume
