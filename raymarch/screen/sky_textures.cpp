#include "raymarch/screen/sky_textures.h"

#include "raymarch/gl_check.h"
#include "raymarch/screen/sky_convolution.h"

namespace isolume {
namespace {

// As in the shaders.
constexpr GLuint kConeUnit = 8;

SkyCube skyOrWhite(const std::shared_ptr<const SkyCube>& sky) {
  if (sky) return *sky;
  SkyCube white;
  addEvenSky(white, glm::vec3(1));
  return white;
}

}  // namespace

void SkyTextures::makeCones(const SkyCube& sky, int count) {
  cones_ = GlTexture::create(GL_TEXTURE_CUBE_MAP_ARRAY);
  glTextureStorage3D(cones_.name(), 1, GL_RGBA32F, kConeSide, kConeSide, kCubeFaces * count);
  glTextureParameteri(cones_.name(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(cones_.name(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  GLint layer = 0;
  for (const std::vector<glm::vec3>& cube : convolvedSky(sky, kConeAngles - count)) {
    glTextureSubImage3D(cones_.name(), 0, 0, 0, layer, kConeSide, kConeSide, kCubeFaces, GL_RGB, GL_FLOAT, cube.data());
    layer += kCubeFaces;
  }
  coneCount_ = count;
}

void SkyTextures::use(const std::shared_ptr<const SkyCube>& sky, const SkyNeeds& needs) {
  if (!made_ || sky != sky_) *this = SkyTextures();
  made_ = true;
  sky_ = sky;
  if (needs.cones > 0) {
    if (coneCount_ < needs.cones) makeCones(skyOrWhite(sky), needs.cones);
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    glBindTextureUnit(kConeUnit, cones_.name());
  }
  checkGl("sky");
}

}  // namespace isolume
