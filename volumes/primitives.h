// Exact signed distances of a few solids, d < 0 inside. The union of several is the least of them: exact outside, and
// inside only a lower bound of the depth.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace isolume {

struct Sphere {
  glm::dvec3 center;
  double radius;
};
inline double distanceTo(const Sphere& sphere, glm::dvec3 p) { return glm::length(p - sphere.center) - sphere.radius; }

/// All points within a radius of the segment a b, where the radius goes linearly from one end to the other: two balls
/// and the cone that touches both.
struct TaperedCapsule {
  glm::dvec3 a, b;
  double radiusA, radiusB;
};
inline double distanceTo(const TaperedCapsule& capsule, glm::dvec3 p) {
  const glm::dvec3 axis = capsule.b - capsule.a, fromA = p - capsule.a, fromB = p - capsule.b;
  const double length = glm::length(axis);
  const double sine = length > 0 ? (capsule.radiusA - capsule.radiusB) / length : 2;
  if (sine >= 1 || sine <= -1)  // one ball holds the other: there is no cone
    return std::min(glm::length(fromA) - capsule.radiusA, glm::length(fromB) - capsule.radiusB);
  const double cosine = std::sqrt(1 - sine * sine);
  const double along = glm::dot(fromA, axis) / length;
  const double across = std::sqrt(std::max(0.0, glm::dot(fromA, fromA) - along * along));
  // The cone's normal through p leaves the axis here; beyond the ends a ball is nearer.
  const double foot = along - across * sine / cosine;
  if (foot <= 0) return glm::length(fromA) - capsule.radiusA;
  if (foot >= length) return glm::length(fromB) - capsule.radiusB;
  return across * cosine + along * sine - capsule.radiusA;
}

/// A solid's own axes: world = position + axes * local.
struct Pose {
  glm::dvec3 position{0};
  glm::dmat3 axes{1};
};
inline glm::dvec3 localFromWorld(const Pose& pose, glm::dvec3 p) { return (p - pose.position) * pose.axes; }

/// Distance from a local point to a box about the origin. The same formula in 2D serves a cylinder.
template <class Vector>
double boxDistance(Vector p, Vector halfSize) {
  const Vector q = glm::abs(p) - halfSize;
  double inside = q[0];
  for (int i = 1; i < Vector::length(); ++i) inside = std::max(inside, q[i]);
  return glm::length(glm::max(q, Vector(0))) + std::min(inside, 0.0);
}

/// Cylinder about the local z axis.
inline double cylinderDistance(glm::dvec3 p, double radius, double halfHeight) {
  const glm::dvec2 profile(glm::length(glm::dvec2(p)), p.z);
  return boxDistance(profile, glm::dvec2(radius, halfHeight));
}

/// Ring about the local z axis.
inline double torusDistance(glm::dvec3 p, double ringRadius, double tubeRadius) {
  return glm::length(glm::dvec2(glm::length(glm::dvec2(p)) - ringRadius, p.z)) - tubeRadius;
}

}  // namespace isolume
