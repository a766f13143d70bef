#include "src/suggest.h"

#include <gtest/gtest.h>

namespace isolume {
namespace {

TEST(EditDistance, CountsSingleLetterEdits) {
  // Insertion, deletion, replacement and a swap of neighbours each count one.
  EXPECT_EQ(editDistance("", ""), 0);
  EXPECT_EQ(editDistance("", "abc"), 3);
  EXPECT_EQ(editDistance("isovalue", "isovalue"), 0);
  EXPECT_EQ(editDistance("isovalu", "isovalue"), 1);
  EXPECT_EQ(editDistance("isovvalue", "isovalue"), 1);
  EXPECT_EQ(editDistance("isovelue", "isovalue"), 1);
  EXPECT_EQ(editDistance("isovlaue", "isovalue"), 1);
  EXPECT_EQ(editDistance("kitten", "sitting"), 3);
}

TEST(EditDistance, IsSymmetric) {
  // Turning a into b costs what turning b into a costs.
  for (const char* a : {"", "a", "gamma", "--samples", "abcd"})
    for (const char* b : {"b", "gmama", "--sample", "dcba"})
      EXPECT_EQ(editDistance(a, b), editDistance(b, a)) << a << b;
}

TEST(DidYouMean, NamesTheNearestWordOrNothing) {
  // A slip gets the word that was meant, a word like no other gets no suggestion.
  const std::vector<std::string> known{"--isovalue", "--inside", "--samples", "--size"};
  EXPECT_EQ(didYouMean("--isovlaue", known), "; did you mean --isovalue?");
  EXPECT_EQ(didYouMean("--sample", known), "; did you mean --samples?");
  EXPECT_EQ(didYouMean("--sise", known), "; did you mean --size?");
  EXPECT_EQ(didYouMean("--photon-map", known), "");
  EXPECT_EQ(didYouMean("", known), "");
}

}  // namespace
}  // namespace isolume
