// The uniform block of the octants' light as a C++ struct, from the same text as in GLSL, and its values.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "sweep/octants.h"
#include "sweep/octants/geometry_terms.h"

namespace isolume {
namespace shader {

using glm::vec4;
#include "shaders/shared/octant_lights.h"

// std140: arrays of vec4.
static_assert(sizeof(OctantLights) == 7 * 16);
static_assert(offsetof(OctantLights, high) == 3 * 16);
static_assert(offsetof(OctantLights, most) == 6 * 16);

}  // namespace shader

/// `light`: of each octant of kOctants, linear. `term` as of the tables.
shader::OctantLights makeOctantLights(const std::array<glm::vec3, kOctantCount>& light, GeometryTerm term);

}  // namespace isolume
