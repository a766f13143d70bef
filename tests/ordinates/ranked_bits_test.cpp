// Sets whose members are numbered.
#include "sweep/ordinates/ranked_bits.h"

#include <gtest/gtest.h>

#include <utility>

#include "support/random_numbers.h"

namespace isolume {
namespace {

TEST(RankedBits, NumberMembersInTheOrderOfTheSamples) {
  // In rows that end before, at and behind a word's end, every sample's number is how many members precede it.
  test::RandomNumbers numbers(7);
  for (const int length : {1, 31, 32, 33, 63, 64, 65, 128, 130})
    for (const int rarity : {1, 2, 9, 500}) {
      SCOPED_TRACE(testing::Message() << length << ", one in " << rarity);
      const glm::ivec3 size(length, 5, 3);
      BitGrid bits(size), want(size);
      for (int i = 0; i < length * 15; ++i) {
        if (numbers.below(rarity) != 0) continue;
        for (BitGrid* each : {&bits, &want}) each->mark(i % length, i / length % 5, i / length / 5);
      }
      const RankedBits got(std::move(bits));
      std::uint32_t members = 0;
      for (int i = 0; i < length * 15; ++i) {
        const glm::ivec3 at(i % length, i / length % 5, i / length / 5);
        ASSERT_EQ(got.number(at), members) << i;
        ASSERT_EQ(got.test(at), want.test(at.x, at.y, at.z)) << i;
        members += got.test(at) ? 1 : 0;
      }
      EXPECT_EQ(got.count(), members);
    }
}

}  // namespace
}  // namespace isolume
