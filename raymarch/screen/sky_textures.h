// The sky on the GPU, as the screen-space passes look it up. Each part is made when a picture first needs it, and again
// when the sky is another one.
#pragma once

#include <memory>

#include "raymarch/gl_objects.h"
#include "raymarch/screen/screen_plan.h"

namespace isolume {

/// GPU memory: 96 KiB for each cone, 384 KiB of radiance, 50 KiB of draws (RGBA32F).
class SkyTextures {
 public:
  /// Makes what is missing and binds it. No sky: an even one of radiance 1.
  void use(const std::shared_ptr<const SkyCube>& sky, const SkyNeeds& needs);

 private:
  void makeCones(const SkyCube& sky, int count);
  void makeRadiance(const SkyCube& sky);
  void makeDraws(const SkyCube& sky);

  std::shared_ptr<const SkyCube> sky_;
  bool made_ = false;
  GlTexture cones_, radiance_, draws_;
  int coneCount_ = 0;
};

}  // namespace isolume
