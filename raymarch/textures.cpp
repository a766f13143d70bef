#include "textures.h"

#include <fmt/format.h>

#include <algorithm>

#include "gl_check.h"
#include "gpu_error.h"

namespace isolume {
namespace {

std::string describe(const std::string& what, glm::ivec3 size, const TexelFormat& format) {
  const double mebibytes = static_cast<double>(size.x) * size.y * size.z * format.bytes / (1 << 20);
  return fmt::format("{} texture of {}x{}x{} {} ({:.0f} MiB)", what, size.x, size.y, size.z, format.name, mebibytes);
}

void checkExtent(const std::string& what, glm::ivec3 size, int extent, GLenum limitName, const TexelFormat& format) {
  GLint limit = 0;
  glGetIntegerv(limitName, &limit);
  if (extent > limit) {
    throw GpuError(fmt::format("{}: expected at most {} texels per axis on this GPU, found {}",
                               describe(what, size, format), limit, extent));
  }
}

[[noreturn]] void refuse(const std::string& what, glm::ivec3 size, const TexelFormat& format) {
  const auto* renderer = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
  throw GpuError(fmt::format("{}: larger than {} takes or has memory for", describe(what, size, format),
                             renderer ? renderer : "this GPU"));
}

// Drivers report an allocation that failed at once, or only when the texture is first written.
void checkAllocated(const std::string& what, glm::ivec3 size, const TexelFormat& format) {
  const GLenum error = glGetError();
  if (error == GL_OUT_OF_MEMORY) refuse(what, size, format);
  if (error != GL_NO_ERROR)
    throw GpuError(fmt::format("{}: OpenGL error {:#06x}", describe(what, size, format), error));
}

void setSampling(GLuint texture, GLint filter) {
  glTextureParameteri(texture, GL_TEXTURE_MIN_FILTER, filter);
  glTextureParameteri(texture, GL_TEXTURE_MAG_FILTER, filter);
  for (GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R}) {
    glTextureParameteri(texture, axis, GL_CLAMP_TO_EDGE);
  }
}

GlTexture makeVolume(GLenum target, GLenum proxy, const std::string& what, glm::ivec3 size, const TexelFormat& format,
                     GLint filter, int most, const SliceSource& slices) {
  glTexImage3D(proxy, 0, static_cast<GLint>(format.internal), size.x, size.y, size.z, 0, format.format, format.type,
               nullptr);
  GLint width = 0;
  glGetTexLevelParameteriv(proxy, 0, GL_TEXTURE_WIDTH, &width);
  glGetError();  // some drivers raise an error beside refusing the proxy
  if (width == 0) refuse(what, size, format);
  GlTexture texture = GlTexture::create(target);
  glTextureStorage3D(texture.name(), 1, format.internal, size.x, size.y, size.z);
  checkAllocated(what, size, format);
  setSampling(texture.name(), filter);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  for (int begin = 0; begin < size.z; begin += most) {
    const int end = std::min(begin + most, size.z);
    glTextureSubImage3D(texture.name(), 0, 0, 0, begin, size.x, size.y, end - begin, format.format, format.type,
                        slices(begin, end));
    checkAllocated(what, size, format);
  }
  return texture;
}

}  // namespace

GlTexture makeTexture3D(const std::string& what, glm::ivec3 size, const TexelFormat& format, GLint filter,
                        const void* texels) {
  checkGl("before the " + what + " texture");
  checkExtent(what, size, std::max({size.x, size.y, size.z}), GL_MAX_3D_TEXTURE_SIZE, format);
  return makeVolume(GL_TEXTURE_3D, GL_PROXY_TEXTURE_3D, what, size, format, filter, size.z,
                    [texels](int, int) { return texels; });
}

GlTexture makeTextureSlices(const std::string& what, glm::ivec3 size, const TexelFormat& format, GLint filter, int most,
                            const SliceSource& slices) {
  checkGl("before the " + what + " texture");
  checkExtent(what, size, std::max(size.x, size.y), GL_MAX_TEXTURE_SIZE, format);
  checkExtent(what, size, size.z, GL_MAX_ARRAY_TEXTURE_LAYERS, format);
  return makeVolume(GL_TEXTURE_2D_ARRAY, GL_PROXY_TEXTURE_2D_ARRAY, what, size, format, filter, most, slices);
}

GlTexture makeTextureSlices(const std::string& what, glm::ivec3 size, const TexelFormat& format, GLint filter,
                            const void* texels) {
  return makeTextureSlices(what, size, format, filter, size.z, [texels](int, int) { return texels; });
}

GlTexture makeTexture2D(const std::string& what, glm::ivec2 size, const TexelFormat& format, GLint filter,
                        const void* texels) {
  checkGl("before the " + what + " texture");
  const glm::ivec3 size3(size, 1);
  checkExtent(what, size3, std::max(size.x, size.y), GL_MAX_TEXTURE_SIZE, format);
  GlTexture texture = GlTexture::create(GL_TEXTURE_2D);
  glTextureStorage2D(texture.name(), 1, format.internal, size.x, size.y);
  checkAllocated(what, size3, format);
  setSampling(texture.name(), filter);
  if (texels) {
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTextureSubImage2D(texture.name(), 0, 0, 0, size.x, size.y, format.format, format.type, texels);
    checkAllocated(what, size3, format);
  }
  return texture;
}

}  // namespace isolume
