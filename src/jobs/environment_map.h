// A picture of the sky from a file.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

namespace isolume {

/// Equirectangular, row-major, top row first, linear; sweep/reference/environment.h says how it lies in the world.
struct EnvironmentMap {
  glm::ivec2 size{0};
  std::vector<glm::vec3> radiance;  ///< finite, >= 0
};

/// InputError for a file without R, G and B, and for a pixel that is negative or not finite.
EnvironmentMap readEnvironmentMap(const std::string& path);

}  // namespace isolume
