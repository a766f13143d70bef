// [Singh10] Fig. 3's kind of scene, made to be checked: flat walls, where the method's diagonal shadows show, and four
// solids whose occlusion everyone can judge. All rotations are by Pythagorean triples, hence exact.
#include <cmath>

#include "scene_families.h"

namespace isolume {
namespace {

constexpr double kWall = 0.12;  // thickness of floor and walls: the room is [.12, 1] x [0, .88] x [.12, 1]

double roomDistance(glm::dvec3 p) { return std::min({p.x - kWall, 1 - kWall - p.y, p.z - kWall}); }

constexpr glm::dvec3 onFloor(double x, double y, double height) { return {x, y, kWall + height}; }

double boxInRoom(glm::dvec3 p) {
  constexpr glm::dvec3 kHalf{0.11, 0.11, 0.15};
  // Turned about z by the angle of the triangle 5, 12, 13.
  static const Pose pose{onFloor(0.70, 0.64, kHalf.z),
                         glm::dmat3(12. / 13, 5. / 13, 0, -5. / 13, 12. / 13, 0, 0, 0, 1)};
  return boxDistance(localFromWorld(pose, p), kHalf);
}

double columnDistance(glm::dvec3 p) {
  constexpr double kRadius = 0.055, kFootRadius = 0.08, kHalfHeight = 0.36, kFootHalfHeight = 0.025;
  const glm::dvec3 q = p - onFloor(0.30, 0.68, 0);
  const double shaft = cylinderDistance(q - glm::dvec3(0, 0, kHalfHeight), kRadius, kHalfHeight);
  const double foot = cylinderDistance(q - glm::dvec3(0, 0, kFootHalfHeight), kFootRadius, kFootHalfHeight);
  const double head =
      cylinderDistance(q - glm::dvec3(0, 0, 2 * kHalfHeight - kFootHalfHeight), kFootRadius, kFootHalfHeight);
  return std::min({shaft, foot, head});
}

double sphereInRoom(glm::dvec3 p) {
  constexpr double kRadius = 0.13;
  return distanceTo(Sphere{onFloor(0.38, 0.34, kRadius), kRadius}, p);
}

double torusInRoom(glm::dvec3 p) {
  constexpr double kRing = 0.11, kTube = 0.042;
  // Tilted about x by the angle of the triangle 7, 24, 25, and resting on the floor.
  constexpr double kSine = 7. / 25, kCosine = 24. / 25;
  static const Pose pose{onFloor(0.74, 0.26, kRing * kSine + kTube),
                         glm::dmat3(1, 0, 0, 0, kCosine, kSine, 0, -kSine, kCosine)};
  return torusDistance(localFromWorld(pose, p), kRing, kTube);
}

}  // namespace

double cornerValue(glm::dvec3 p) {
  return std::min({roomDistance(p), boxInRoom(p), columnDistance(p), sphereInRoom(p), torusInRoom(p)});
}

}  // namespace isolume
