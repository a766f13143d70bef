#include "raymarch/screen/sky_textures.h"

#include "raymarch/gl_check.h"
#include "raymarch/screen/sky_convolution.h"
#include "raymarch/screen/sky_draws.h"
#include "raymarch/textures.h"

namespace isolume {
namespace {

// As in the shaders.
constexpr GLuint kConeUnit = 8, kSkyUnit = 13, kDrawUnit = 14;

SkyCube skyOrWhite(const std::shared_ptr<const SkyCube>& sky) {
  if (sky) return *sky;
  SkyCube white;
  addEvenSky(white, glm::vec3(1));
  return white;
}

void filterLinearly(const GlTexture& texture) {
  glTextureParameteri(texture.name(), GL_TEXTURE_MIN_FILTER, GL_LINEAR);
  glTextureParameteri(texture.name(), GL_TEXTURE_MAG_FILTER, GL_LINEAR);
}

}  // namespace

void SkyTextures::makeCones(const SkyCube& sky, int count) {
  cones_ = GlTexture::create(GL_TEXTURE_CUBE_MAP_ARRAY);
  glTextureStorage3D(cones_.name(), 1, GL_RGBA32F, kConeSide, kConeSide, kCubeFaces * count);
  filterLinearly(cones_);
  GLint layer = 0;
  for (const std::vector<glm::vec3>& cube : convolvedSky(sky, kConeAngles - count)) {
    glTextureSubImage3D(cones_.name(), 0, 0, 0, layer, kConeSide, kConeSide, kCubeFaces, GL_RGB, GL_FLOAT, cube.data());
    layer += kCubeFaces;
  }
  coneCount_ = count;
}

void SkyTextures::makeRadiance(const SkyCube& sky) {
  radiance_ = GlTexture::create(GL_TEXTURE_CUBE_MAP);
  glTextureStorage2D(radiance_.name(), 1, GL_RGBA32F, sky.side, sky.side);
  filterLinearly(radiance_);
  glTextureSubImage3D(radiance_.name(), 0, 0, 0, 0, sky.side, sky.side, kCubeFaces, GL_RGB, GL_FLOAT,
                      sky.radiance.data());
}

void SkyTextures::makeDraws(const SkyCube& sky) {
  draws_ = makeTexture2D("sky", {1 + 2 * kCellDraws, kSkyCells}, kRGBA32F, GL_NEAREST, skyDraws(sky).data());
}

void SkyTextures::use(const std::shared_ptr<const SkyCube>& sky, const SkyNeeds& needs) {
  if (needs == SkyNeeds{}) return;  // the sky of the picture before stays
  if (!made_ || sky != sky_) *this = SkyTextures();
  made_ = true;
  sky_ = sky;
  if (needs.cones > 0) {
    if (coneCount_ < needs.cones) makeCones(skyOrWhite(sky), needs.cones);
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    glBindTextureUnit(kConeUnit, cones_.name());
  }
  if (needs.radiance) {
    if (!radiance_) makeRadiance(skyOrWhite(sky));
    glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    glBindTextureUnit(kSkyUnit, radiance_.name());
  }
  if (needs.draws) {
    if (!draws_) makeDraws(skyOrWhite(sky));
    glBindTextureUnit(kDrawUnit, draws_.name());
  }
  checkGl("sky");
}

}  // namespace isolume
