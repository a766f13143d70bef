// The colouring field of a scene on the GPU, and the programs that read it.
#pragma once

#include <string_view>

#include "color_field.h"
#include "gl_objects.h"

namespace isolume {

class SurfaceColors {
 public:
  /// None: the surface has the albedo of the settings.
  SurfaceColors() = default;
  /// For a picture grid that stands at `worldFromGrid`. GpuError for a map of fewer than two colours, or what the GPU
  /// does not take.
  SurfaceColors(const ColorField& field, glm::dmat4 worldFromGrid);

  explicit operator bool() const { return static_cast<bool>(field_); }
  void bind() const;

 private:
  GlTexture field_, map_;  // R32F, samples; RGBA32F, colours
  GlBuffer uniforms_;
};

/// Where the positions of the pixels are bound for the programs of the screen.
inline constexpr GLuint kColorPositionUnit = 18;

/// The text of a shader file for a scene that is coloured by a field, or is not.
std::string_view coloredShader(std::string_view name, bool colored);

}  // namespace isolume
