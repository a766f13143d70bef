#include "src/cli/presets.h"

#include <functional>
#include <initializer_list>

#include "src/cli/light_options.h"
#include "src/cli/parse_value.h"

namespace isolume {
namespace {

constexpr const char* kOption = "--preset";

void setLights(RenderJob& job, std::initializer_list<const char*> lights) {
  job.light.lights.clear();
  for (const char* light : lights) job.light.lights.push_back(parseLight(kOption, light));
}

/// The published look: eight octants at the hit, and the gamma that stands for light between surfaces.
void singh10(RenderJob& job) {
  constexpr double kPublishedGamma = 2;
  job.occlusion.method = OcclusionMethod::singh10;
  job.gamma = kPublishedGamma;
}

/// A matt model in an overcast yard: shape by openness and by what surfaces send each other, and a little direction.
void clay(RenderJob& job) {
  job.albedo = parseColor(kOption, "#c9ab94");
  setLights(job, {"sky:intensity=.8", "sun:from=camera:azimuth=-40:elevation=45:radius=15:intensity=.35"});
  job.light.bounces = kAllBounces;
}

/// Key, fill and rim, all as seen from the camera.
void studio(RenderJob& job) {
  setLights(job, {"gradient:zenith=#e8efff:horizon=#b0b8c4:ground=#77706a:intensity=.55",
                  "sun:from=camera:azimuth=-45:elevation=40:radius=8:color=#fff2e2:intensity=.75",
                  "sun:from=camera:azimuth=140:elevation=25:radius=5:color=#dfe9ff:intensity=.4"});
  job.light.bounces = kAllBounces;
}

/// The standard overcast sky, three times as bright above as at the horizon, and a dull ground: [Singh10] Fig. 7 with
/// ordinates.
void cloudy(RenderJob& job) {
  setLights(job, {"gradient:zenith=white:horizon=#9c9c9c:ground=#595959:intensity=1.2"});
  job.light.bounces = kAllBounces;
}

/// [Singh10] Fig. 10 with ordinates: light comes through what is thin.
void translucent(RenderJob& job) {
  job.albedo = parseColor(kOption, "#d8c8b0");
  job.light.exposure = -0.25;
  job.light.freePathShare = kTranslucentShare;
}

}  // namespace

void applyPreset(std::string_view option, std::string_view name, RenderJob& job) {
  const Choices<std::function<void(RenderJob&)>> presets{
      {"singh10", singh10}, {"clay", clay}, {"studio", studio}, {"cloudy", cloudy}, {"translucent", translucent}};
  parseChoice(option, name, presets)(job);
}

}  // namespace isolume
