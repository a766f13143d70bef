#include "nearest.h"
#include "scene_families.h"
#include "vascular_tree.h"

namespace isolume {
namespace {

const NearestPrimitive<TaperedCapsule>& scene() {
  constexpr int kDepth = 5;  // 32^3 cells: as small as the distance between vessels
  static const NearestPrimitive<TaperedCapsule> instance(growVascularTree(), kDepth);
  return instance;
}

}  // namespace

double capillariesValue(glm::dvec3 p) { return scene()(p); }
const std::vector<TaperedCapsule>& capillariesPrimitives() { return scene().primitives(); }

}  // namespace isolume
