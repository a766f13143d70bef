#include <cmath>

#include "nearest.h"
#include "random.h"
#include "scene_families.h"

namespace isolume {
namespace {

std::vector<TaperedCapsule> makeCapsules() {
  constexpr int kCount = 60;
  constexpr double kRadius = 0.018, kShortest = 0.2, kLongest = 0.5;
  constexpr double kMargin = 0.05;  // between the border of the cube and any axis
  constexpr std::uint64_t kSeed = 60;
  Random random(kSeed);
  std::vector<TaperedCapsule> capsules;
  while (capsules.size() < kCount) {
    const glm::dvec3 center = random.inBox(kMargin, 1 - kMargin);
    const glm::dvec3 half = random.direction() * (random.uniform(kShortest, kLongest) / 2);
    const auto inside = [&](glm::dvec3 p) {
      return glm::all(glm::greaterThan(p, glm::dvec3(kMargin))) && glm::all(glm::lessThan(p, glm::dvec3(1 - kMargin)));
    };
    if (inside(center - half) && inside(center + half))
      capsules.push_back({center - half, center + half, kRadius, kRadius});
  }
  return capsules;
}

const NearestPrimitive<TaperedCapsule>& scene() {
  constexpr int kDepth = 4;  // 16^3 cells, a few candidates in each
  static const NearestPrimitive<TaperedCapsule> instance(makeCapsules(), kDepth);
  return instance;
}

}  // namespace

double capsulesValue(glm::dvec3 p) { return scene()(p); }
const std::vector<TaperedCapsule>& capsulesPrimitives() { return scene().primitives(); }

}  // namespace isolume
