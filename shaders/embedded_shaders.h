// The GLSL files of this folder as text, embedded when the library is built.
#pragma once

#include <string_view>
#include <vector>

namespace isolume {

struct EmbeddedShader {
  std::string_view name;  ///< "shaders/march_octants.frag"
  std::string_view text;
};
const std::vector<EmbeddedShader>& embeddedShaders();

}  // namespace isolume
