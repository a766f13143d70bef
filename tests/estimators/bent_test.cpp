// Mean open direction and cone, [Klehm11] Sec. 3.1 and 3.2.
#include <gtest/gtest.h>

#include "estimators/closed_form.h"

namespace isolume::test {
namespace {

ChannelEstimate bentAt(const ReferenceScene& scene, const ShadedPoint& point) {
  IntegrandSettings settings;
  settings.integrand = Integrand::bent;
  return estimateAt(scene, settings, {.rays = 1 << 16}, point, 0).channels;
}

TEST(Bent, OpenPointGivesItsNormalAndTheHemisphere) {
  // The mean direction of a whole hemisphere is its axis, half a unit long: the cone is pi / 2.
  const TestScene plane(glm::ivec3(9), glm::dvec3(1), [](glm::dvec3 p) { return floorLevel(p, 4); });
  const ChannelEstimate got = bentAt(plane.scene(), pointOn({4, 4, 4}));
  const Channels want{0, 0, 1, kPi / 2};
  for (std::size_t c = 0; c < want.size(); ++c)
    // x and y are means of even functions of stratified points: their own error is as small as its estimate. The cone
    // is cut off at pi / 2, which halves what noise can do.
    EXPECT_NEAR(got.value[c], want[c], allowed(got.standardError[c]) + 1e-6) << c;
  EXPECT_LT(got.standardError[0], 1e-4);
}

TEST(Bent, FootOfAWallLeansHalfWayOut) {
  // The open quarter sphere has the mean (1/2, 0, 1/2): the direction leans by 45 degrees, and its length sqrt(1/2)
  // gives the cone (2 - sqrt(2)) pi / 2.
  const TestScene corner(glm::ivec3(17), glm::dvec3(1),
                         [](glm::dvec3 p) { return std::max(floorLevel(p, 4), 5 - p.x); });
  const ShadedPoint point = pointOn({5, 8, 4});
  const ChannelEstimate got = bentAt(corner.scene(), point);
  const Channels want{std::sqrt(0.5), 0, std::sqrt(0.5), (2 - std::sqrt(2.0)) * kPi / 2};
  for (std::size_t c = 0; c < want.size(); ++c) {
    EXPECT_NEAR(got.value[c], want[c], allowed(got.standardError[c])) << c;
    EXPECT_LT(got.standardError[c], 1e-3);
  }
  // In a world that has the grid's x along its y, the direction leans there.
  const glm::dmat3 turn(glm::dvec3(0, 1, 0), glm::dvec3(-1, 0, 0), glm::dvec3(0, 0, 1));
  const ChannelEstimate turned = bentAt({corner.tracer, turn}, point);
  EXPECT_NEAR(turned.value[1], got.value[0], 1e-12);  // the same samples, turned: rounding
  EXPECT_NEAR(turned.value[3], got.value[3], 1e-12);
}

TEST(Bent, ClosedPointHasNoDirection) {
  // Where nothing is open there is neither a direction nor a cone: zeros, and no NaN in the errors.
  const TestScene box(glm::ivec3(17), glm::dvec3(1), [](glm::dvec3 p) {
    const glm::dvec3 wall = glm::abs(p - 8.0) - 5.0;
    return std::max({wall.x, wall.y, wall.z});
  });
  const ChannelEstimate got = bentAt(box.scene(), pointOn({8, 8, 3}));
  for (std::size_t c = 0; c < got.value.size(); ++c) {
    EXPECT_EQ(got.value[c], 0);
    EXPECT_EQ(got.standardError[c], 0);
  }
}

}  // namespace
}  // namespace isolume::test
