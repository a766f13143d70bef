// Making textures, with every way in which a driver may refuse them turned into a GpuError with numbers.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>

#include "gl_objects.h"

namespace isolume {

/// What the texels are on both sides.
struct TexelFormat {
  GLenum internal;   ///< GL_R32F, ...
  GLenum format;     ///< GL_RED, ...
  GLenum type;       ///< GL_FLOAT, ...
  int bytes;         ///< per texel
  const char* name;  ///< for messages
};
inline constexpr TexelFormat kR32F{GL_R32F, GL_RED, GL_FLOAT, 4, "R32F"};
inline constexpr TexelFormat kR16F{GL_R16F, GL_RED, GL_HALF_FLOAT, 2, "R16F"};
inline constexpr TexelFormat kR16{GL_R16, GL_RED, GL_UNSIGNED_SHORT, 2, "R16"};
inline constexpr TexelFormat kR8UI{GL_R8UI, GL_RED_INTEGER, GL_UNSIGNED_BYTE, 1, "R8UI"};
inline constexpr TexelFormat kRGBA8{GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE, 4, "RGBA8"};
inline constexpr TexelFormat kRGBA32F{GL_RGBA32F, GL_RGBA, GL_FLOAT, 16, "RGBA32F"};

/// Clamped to the edge; `filter` is GL_LINEAR or GL_NEAREST. `what` names it in errors ("level").
GlTexture makeTexture3D(const std::string& what, glm::ivec3 size, const TexelFormat& format, GLint filter,
                        const void* texels);
/// The same as an array of xy slices, filtered within each. A 3D texture cannot be gathered from, and where four texels
/// come with each lookup a software frame is a sixth faster. Nearest lookups are cheaper there as well.
GlTexture makeTextureSlices(const std::string& what, glm::ivec3 size, const TexelFormat& format, GLint filter,
                            const void* texels);
/// The same from up to `most` slices at a time: slices(begin, end) is called in order, and gives texels that are valid
/// until its next call.
using SliceSource = std::function<const void*(int begin, int end)>;
GlTexture makeTextureSlices(const std::string& what, glm::ivec3 size, const TexelFormat& format, GLint filter, int most,
                            const SliceSource& slices);
/// One image, otherwise the same. `texels` may be nullptr: undefined content, to be drawn into.
GlTexture makeTexture2D(const std::string& what, glm::ivec2 size, const TexelFormat& format, GLint filter,
                        const void* texels);

}  // namespace isolume
