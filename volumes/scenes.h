// The sample scenes, each defined once: `isolume sample`, tests and benchmarks all evaluate these functions.
//
// Every scene is an implicit function f(p) over the unit cube, f < 0 inside the solid. Where `exactDistance` holds, f
// is the exact signed distance in the open space outside the solid (and |grad f| = 1); elsewhere it is implicit only.
// Deterministic: same name, same function, on every machine; no std:: distributions, whose output differs by library.
#pragma once

#include <functional>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "sweep/grid.h"

namespace isolume {

struct Scene {
  std::string name;
  std::string description;  ///< one line, with what it imitates
  bool exactDistance = false;
  std::function<float(glm::dvec3)> value;  ///< p in [0, 1]^3; thread-safe
};

std::vector<std::string_view> sceneNames();     ///< corner, capillaries, gyroid, capsules, spheres, vorticity, terrain
const Scene* findScene(std::string_view name);  ///< nullptr if there is none of that name; lives for ever

/// Samples the scene at the cell centres of an N^3 grid: voxel (i, j, k) at ((i, j, k) + 1/2) / N, spacing 1 / N.
Grid<float> sampleScene(const Scene& scene, int size);

}  // namespace isolume
