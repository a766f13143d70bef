// Runs of bits in rows of words.
#include "sweep/bit_grid.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <utility>
#include <vector>

#include "sweep/mix_bits.h"

namespace isolume {
namespace {

using Runs = std::vector<std::pair<int, int>>;

Runs runsOf(const BitGrid& set) {
  Runs runs;
  forEachRun(set.row(0, 0), set.words(), [&](int begin, int end) { runs.emplace_back(begin, end); });
  return runs;
}

TEST(BitRuns, AreThoseOfALoopOverBits) {
  // On random rows of 200 bits, from nearly empty to nearly full, a run is what one bit after the other says.
  std::uint64_t state = 1;
  for (int i = 0; i < 1000; ++i) {
    BitGrid set({200, 1, 1});
    Runs want;
    for (int x = 0; x < 200; ++x) {
      if (mixBits(state += kSplitMixIncrement) % 100 >= static_cast<std::uint64_t>(i % 100)) continue;
      set.mark(x, 0, 0);
      if (!want.empty() && want.back().second == x) {
        ++want.back().second;
      } else {
        want.emplace_back(x, x + 1);
      }
    }
    ASSERT_EQ(runsOf(set), want);
  }
}

TEST(BitRuns, GoOnAcrossWords) {
  // A full row is one run, an empty one none, and a run from the last bit of a word to the first of the next is one.
  BitGrid full({192, 1, 1}), empty({192, 1, 1}), joint({192, 1, 1});
  for (int x = 0; x < 192; ++x) full.mark(x, 0, 0);
  for (const int x : {63, 64, 191}) joint.mark(x, 0, 0);
  EXPECT_EQ(runsOf(full), (Runs{{0, 192}}));
  EXPECT_EQ(runsOf(empty), Runs());
  EXPECT_EQ(runsOf(joint), (Runs{{63, 65}, {191, 192}}));
}

TEST(BitGrids, KnowTheirEmptyPlanes) {
  // One bit makes its plane, and no other, one that has any.
  BitGrid set({70, 3, 4});
  set.mark(69, 2, 1);
  for (int z = 0; z < 4; ++z) EXPECT_EQ(set.anyInPlane(z), z == 1);
}

}  // namespace
}  // namespace isolume
