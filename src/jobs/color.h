// A colour as the user wrote it and as the renderer takes it.
#pragma once

#include <glm/vec3.hpp>
#include <string>

namespace isolume {

struct Color {
  std::string text;     ///< as given: "white", "#336699", "0.2,0.4,0.6"
  glm::vec3 linear{1};  ///< linear light
};

inline bool isGrey(glm::vec3 color) { return color.r == color.g && color.g == color.b; }

}  // namespace isolume
