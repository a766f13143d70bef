#include <array>
#include <cmath>

#include "nearest.h"
#include "random.h"
#include "scene_families.h"

namespace isolume {
namespace {

struct SizeClass {
  double radius;
  int attempts;  // random places tried: enough that hardly any room for this size is left
};
constexpr std::array<SizeClass, 5> kClasses{{{0.16, 200}, {0.11, 2000}, {0.075, 8000}, {0.05, 20000}, {0.032, 40000}}};

std::vector<Sphere> packSpheres() {
  constexpr double kGap = 0.003;    // between neighbours: they stay apart at 256^3
  constexpr double kMargin = 0.02;  // between the border of the cube and any sphere
  constexpr std::uint64_t kSeed = 5;
  Random random(kSeed);
  std::vector<Sphere> spheres;
  for (const SizeClass& sizeClass : kClasses) {
    const double low = sizeClass.radius + kMargin;
    for (int attempt = 0; attempt < sizeClass.attempts; ++attempt) {
      const Sphere sphere{random.inBox(low, 1 - low), sizeClass.radius};
      if (spheres.empty() || nearestOfAll(spheres, sphere.center) >= sphere.radius + kGap) spheres.push_back(sphere);
    }
  }
  return spheres;
}

const NearestPrimitive<Sphere>& scene() {
  constexpr int kDepth = 4;  // 16^3 cells, a few candidates in each
  static const NearestPrimitive<Sphere> instance(packSpheres(), kDepth);
  return instance;
}

}  // namespace

double spheresValue(glm::dvec3 p) { return scene()(p); }
const std::vector<Sphere>& spheresPrimitives() { return scene().primitives(); }

}  // namespace isolume
