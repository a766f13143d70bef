// The first rise of a cubic, against halving in long double.
#include "sweep/reference/cubic.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "reference/brute_force.h"
#include "reference/random_rays.h"

namespace isolume::test {
namespace {

constexpr int kCubics = 1'000'000;

// Coefficients of one of five families, each as likely: anything; one sign but for one; a double root within; two
// nearly equal roots; sizes far apart.
Cubic randomCubic(std::uint64_t number) {
  Random random(number);
  std::array<double, 4> b;
  for (double& value : b) value = random.uniform(-1, 1);
  const int kind = random.below(5);
  if (kind == 1) {
    for (double& value : b) value = -std::abs(value);
    double& odd = b[static_cast<std::size_t>(random.below(4))];
    odd = -odd;
  } else if (kind == 2 || kind == 3) {
    // (s - r)(s - r - gap)(p + q s), r within: in Bernstein form, products of linear factors.
    const double r = random.uniform(0, 1), gap = kind == 2 ? 0 : std::exp(random.uniform(-35, 0));
    const double p = b[0], q = b[1];
    const double u0 = -r, u1 = 1 - r, v0 = -r - gap, v1 = 1 - r - gap, w0 = p, w1 = p + q;
    b = {u0 * v0 * w0, (u1 * v0 * w0 + u0 * v1 * w0 + u0 * v0 * w1) / 3,
         (u1 * v1 * w0 + u1 * v0 * w1 + u0 * v1 * w1) / 3, u1 * v1 * w1};
  } else if (kind == 4) {
    for (double& value : b) value *= std::exp(random.uniform(-40, 0));
  }
  return {b[0], b[1], b[2], b[3]};
}

TEST(Cubic, FirstRiseAgainstHalving) {
  // On a million cubics the first rise is the one that halving in long double finds, but where f between the two is not
  // above 0 by more than the rounding of f, 8 ulp of the largest coefficient.
  int risen = 0, apart = 0;
  for (int i = 0; i < kCubics; ++i) {
    const Cubic f = randomCubic(static_cast<std::uint64_t>(i));
    const LongCubic b{f.b0, f.b1, f.b2, f.b3};
    const double size = std::max({std::abs(f.b0), std::abs(f.b1), std::abs(f.b2), std::abs(f.b3)});
    const auto got = firstRise(f);
    const auto want = firstRiseByHalving(b);
    ASSERT_EQ(rises(f), got.has_value()) << i;
    risen += want ? 1 : 0;
    const long double gotAt = got ? *got : 1, wantAt = want ? *want : 1;
    ASSERT_TRUE(gotAt >= 0 && gotAt <= 1) << i;
    if (got.has_value() == want.has_value() && std::abs(gotAt - wantAt) < 1e-14L) continue;
    ++apart;
    ASSERT_LE(maximumOf(b, std::min(gotAt, wantAt), std::max(gotAt, wantAt)), 8 * 0x1p-52L * size) << i;
  }
  EXPECT_GT(risen, kCubics / 2);
  EXPECT_LT(risen, kCubics * 9 / 10);
  // A share of those with nearly equal roots: they are what the bound above is for.
  EXPECT_LT(apart, kCubics / 5);
  RecordProperty("apart", apart);
}

TEST(Cubic, PositiveShareIsAllButThatOfItsNegative) {
  // What is above 0 and what is below fill [0, 1], but for a double root, which rounding opens as wide as its own
  // square root; and of a cubic that only rises the share is what lies beyond the rise.
  constexpr double kTouch = 0x1p-24;
  int rising = 0;
  for (int i = 0; i < kCubics; ++i) {
    const Cubic f = randomCubic(static_cast<std::uint64_t>(i));
    const double above = positiveShare(f);
    ASSERT_NEAR(above + positiveShare(-f), 1, kTouch) << i;
    if (!(f.b0 < 0 && f.b0 <= f.b1 && f.b1 <= f.b2 && f.b2 <= f.b3 && f.b3 > 0)) continue;
    ++rising;
    ASSERT_NEAR(above, 1 - *firstRise(f), 0x1p-50) << i;
  }
  EXPECT_GT(rising, kCubics / 200);
}

TEST(Cubic, Ends) {
  // The rise is at 0 if f starts above 0 or rises from 0, at 1 at the latest if it ends above 0, and nowhere if f only
  // reaches 0.
  EXPECT_EQ(firstRise({1, -1, -1, -1}), 0);
  EXPECT_EQ(firstRise({0, 1, -1, -1}), 0);
  EXPECT_EQ(firstRise({0, 0, 0, 1}), 0);
  EXPECT_EQ(firstRise({-1, -1, -1, 0}), std::nullopt);
  EXPECT_EQ(firstRise({0, 0, 0, 0}), std::nullopt);
  EXPECT_EQ(firstRise({0, -1, 0, 0}), std::nullopt);
  const auto late = firstRise({-1, -1, -1, 1e-17});
  ASSERT_TRUE(late);
  EXPECT_NEAR(*late, 1, 0x1p-52);
}

TEST(Cubic, ExactDoubleRoot) {
  // f = -(s - 1/2)^2, all of whose coefficients are exact, touches 0 and does not rise; lifted by 2^-50 it does, within
  // the square root of that.
  const Cubic touch{-0.25, 1.0 / 12, 1.0 / 12, -0.25};
  const Cubic below = touch - 0x1p-50, above = touch - -0x1p-50;
  EXPECT_FALSE(firstRise(below));
  const auto rise = firstRise(above);
  ASSERT_TRUE(rise);
  EXPECT_NEAR(*rise, 0.5 - 0x1p-25, 0x1p-27) << "1/12 is rounded by 2^-57, a 64th of the lift";
}

}  // namespace
}  // namespace isolume::test
