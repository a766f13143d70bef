// One function per scene, and the primitives behind those that have any: for scenes.cpp and for tests. All values as
// Scene::value, in double precision; what is built on the first call is shared afterwards. Thread-safe.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "primitives.h"

namespace isolume {

/// Exact outside. A room's floor and the two walls that a camera at azimuth 30 and elevation 20 looks towards, each .12
/// thick, with a box, a sphere, a torus and a column.
double cornerValue(glm::dvec3 p);

/// Exact outside.
double capillariesValue(glm::dvec3 p);
const std::vector<TaperedCapsule>& capillariesPrimitives();

/// Implicit: the sheet |g| < 1/2 about the gyroid g = 0, three periods across the cube, cut by a ball of radius .42.
double gyroidValue(glm::dvec3 p);

/// Exact outside: 60 capsules of radius .018, lengths .2 to .5 between the ends of the axis.
double capsulesValue(glm::dvec3 p);
const std::vector<TaperedCapsule>& capsulesPrimitives();

/// Exact everywhere: balls of five sizes that neither touch each other nor the border.
double spheresValue(glm::dvec3 p);
const std::vector<Sphere>& spheresPrimitives();

/// Implicit: z less the height, which is noise of three octaves about .4; solid below.
double terrainValue(glm::dvec3 p);
double terrainHeight(double x, double y);

/// Implicit: threshold less the magnitude of vorticity(p), faded towards the border. See vorticity.cpp.
double vorticityValue(glm::dvec3 p);
glm::dvec3 vorticity(glm::dvec3 p);  ///< not faded: free of divergence

}  // namespace isolume
