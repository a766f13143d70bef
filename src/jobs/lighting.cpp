#include "src/jobs/lighting.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "raymarch/light_uniforms.h"
#include "raymarch/view.h"
#include "src/errors.h"
#include "src/jobs/color.h"
#include "src/jobs/environment_map.h"
#include "sweep/octants/rotated_shadow.h"
#include "sweep/ordinates/inter_reflection.h"
#include "sweep/ordinates/sky_ordinates.h"
#include "sweep/ordinates/translucency.h"
#include "sweep/transport/transport_sweep.h"

namespace isolume {
namespace {

/// Directions over a disc: as dense as this many over the sphere, and at least kLeastDisc. A disc of 5 degrees has 62.
constexpr double kDiscDensity = 32768;
constexpr int kLeastDisc = 32;
/// A sun that is a point: what it adds to reflections, and the cosine of a turned grid.
constexpr double kPointDegrees = 0.25;
/// World units; of a solid that holds nothing back.
constexpr double kNoOpacity = 1e30;

bool isGreyMap(const EnvironmentMap& map) { return std::all_of(map.radiance.begin(), map.radiance.end(), isGrey); }

int discOrdinates(double radiusDegrees) {
  const double share = (1 - std::cos(glm::radians(radiusDegrees))) / 2;
  return std::clamp(static_cast<int>(kDiscDensity * share), kLeastDisc, kMostOrdinates);
}

/// The sweeps of one picture, one light after the other.
class LightingSweep {
 public:
  LightingSweep(const LightingRequest& request, const OrdinateOptions& ordinates, const SweptScene& scene,
                const Camera& camera, SurfaceRays::Orders orders)
      : request_(request),
        count_(ordinates.ordinates),
        level_(scene.surface.level.view()),
        distance_(scene.swept.distance.view()),
        camera_(camera),
        exposure_(static_cast<float>(std::exp2(request.exposure))),
        opacity_(request.opacity.value_or(1)),
        // Carried rays need a lattice of the samples.
        rays_(level_, distance_, opacity_ < 1 ? 1 : ordinates.refinement, orders),
        worldFromAxes_(makeGridFrame(scene.surface.worldFromGrid).worldFromAxes) {}

  void addLight(const LightRequest& light) {
    const glm::vec3 color = exposure_ * light.color;
    if (light.kind == LightKind::head) swept_.head += color;
    if (light.kind == LightKind::sun) addSun(light, color);
    if (light.kind == LightKind::sky) addWhiteSky(color);
    if (light.kind == LightKind::octants) addSky(octantSky(count_, light.octants), {color});
    if (light.kind == LightKind::gradient)
      addSky(bandedSky(count_, axesFromWorld()),
             {light.bands[0] * color, light.bands[1] * color, light.bands[2] * color});
  }

  void addWhiteSky(glm::vec3 color) {
    open_ += color;
    if (opacity_ < 1) {
      SweptLight thickness = addTranslucent(uniformSky(count_), color);
      if (request_.thickness) swept_.thickness = std::move(thickness);
      return;
    }
    std::vector<float> light = blockedShares(rays_, count_);
    addField({rays_.surface().spread(opennessOf(light)), 1}, color);
    blocked_ = light;
    for (float& each : light) each = std::clamp(1 - each, 0.0F, 1.0F);
    addDirect(light, color);
  }

  void addMap(const EnvironmentMap& map) {
    const std::vector<Ordinate> sky =
        mappedSky(count_, map.size, map.radiance, request_.rotationDegrees.value_or(0), axesFromWorld());
    if (isGreyMap(map))
      addSky(sky, {glm::vec3(exposure_)});
    else
      addSky(sky, {{exposure_, 0, 0}, {0, exposure_, 0}, {0, 0, exposure_}});
  }

  void addReflections(int bounces, glm::vec3 albedo) {
    const InterReflection reflection(coarseRays(), ReflectionOptions().ordinates);
    if (blocked_.empty()) blocked_ = blockedShares(rays_, count_);
    const bool grey = isGrey(albedo) && direct_[0] == direct_[1] && direct_[1] == direct_[2];
    for (int c = 0; c < (grey ? 1 : 3); ++c) {
      const ReflectedLight reflected = reflection.reflect(direct_[static_cast<std::size_t>(c)], blocked_, albedo[c],
                                                          open_[c], {.bounces = bounces == kAllBounces ? 0 : bounces});
      glm::vec3 color(grey ? 1.0F : 0.0F);
      if (!grey) color[c] = 1;
      addField(lightOfFeet(rays_.surface(), reflected.light.data()), color);
    }
  }

  void addThickness() {
    if (!swept_.thickness) swept_.thickness = sweepThickness(coarseRays(), distance_, count_);
  }

  void addBentNormals() { swept_.bent = sweepBentNormals(rays_, count_, worldFromAxes_); }

  SweptLighting take() { return std::move(swept_); }

 private:
  glm::dmat3 axesFromWorld() const { return glm::transpose(worldFromAxes_); }

  const SurfaceRays& coarseRays() {
    if (rays_.lattice().refinement == 1) return rays_;
    if (!coarse_) coarse_.emplace(level_, distance_, 1);
    return *coarse_;
  }

  void addField(SweptLight field, glm::vec3 color, LightField use = {}) {
    use.full = field.full;
    swept_.fields.push_back(std::move(field));
    swept_.uses.push_back(use);
    swept_.colors.push_back(color);
  }

  /// E / pi of each foot, for what the surface sends on.
  void addDirect(const std::vector<float>& light, glm::vec3 color) {
    if (request_.bounces.value_or(0) == 0) return;
    for (int c = 0; c < 3; ++c) {
      std::vector<float>& direct = direct_[static_cast<std::size_t>(c)];
      direct.resize(rays_.count(), 0);
      for (std::size_t i = 0; i < direct.size(); ++i) direct[i] += color[c] * light[i];
    }
  }

  /// One channel for each colour.
  void addSky(const std::vector<Ordinate>& sky, const std::vector<glm::vec3>& colors) {
    for (std::size_t c = 0; c < colors.size(); ++c) {
      // The values of an open point add up to 4 times its light.
      for (const Ordinate& each : sky) open_ += colors[c] * each.value[c] / 4.0F;
      if (opacity_ == 1) continue;
      std::vector<Ordinate> channel = sky;
      for (Ordinate& each : channel) each.value[0] = each.value[c];
      addTranslucent(channel, colors[c]);
    }
    if (opacity_ < 1) return;
    std::vector<SurfaceLight> lights = sweepSky(rays_, sky, static_cast<int>(colors.size()));
    for (std::size_t c = 0; c < colors.size(); ++c) {
      addDirect(lights[c].light, colors[c]);
      addField(std::move(lights[c].field), colors[c]);
    }
  }

  /// The thickness as that sky weighs it.
  SweptLight addTranslucent(const std::vector<Ordinate>& sky, glm::vec3 color) {
    const double path = opacity_ > 0 ? meanFreePath(opacity_, smallestSpacing(level_.spacing)) : kNoOpacity;
    Translucency through = sweepTranslucency(rays_, distance_, sky, path);
    addField(std::move(through.light), color);
    return std::move(through.thickness);
  }

  void addSun(const LightRequest& sun, glm::vec3 color) {
    const glm::dvec3 world = sunDirection(sun, cameraAxes(camera_)), direction = axesFromWorld() * world;
    open_ += color;
    if (sun.shadow == SunShadow::turned) {
      const LightField use{.everywhere = true, .direction = world, .radiusDegrees = kPointDegrees};
      const Grid<std::uint16_t> shadow = sweepRotatedShadow(distance_, direction);
      addField({surfaceField(shadow.view()), 1}, color, use);
    }
    if (sun.shadow == SunShadow::hard) swept_.suns.push_back({world, color});
    const bool soft = sun.shadow == SunShadow::soft;
    if (!soft && request_.bounces.value_or(0) == 0) return;
    const double radius = soft ? sun.radiusDegrees.value_or(kSunDegrees) : kPointDegrees;
    SurfaceLight disc = sweepDisc(rays_, direction, radius, soft ? discOrdinates(radius) : 1);
    addDirect(disc.light, color);
    if (soft) addField(std::move(disc.field), color, {.direction = world, .radiusDegrees = radius});
  }

  const LightingRequest& request_;
  int count_;
  GridView<const float> level_, distance_;
  const Camera& camera_;
  float exposure_;
  double opacity_;
  SurfaceRays rays_;
  std::optional<SurfaceRays> coarse_;
  glm::dmat3 worldFromAxes_;
  std::array<std::vector<float>, 3> direct_;
  std::vector<float> blocked_;  // blockedShares(), once they are known
  glm::vec3 open_{0};           // at least what an open point gets
  SweptLighting swept_;
};

/// UsageError, before anything is swept, if the picture's program has no room for so many.
void checkCounts(const LightingRequest& request, const EnvironmentMap* map, glm::vec3 albedo) {
  std::size_t fields = request.lights.empty() && !map ? 1 : 0, suns = 0;
  bool grey = isGrey(albedo);
  const auto add = [&](std::size_t channels, bool greyLight) {
    fields += channels;
    grey = grey && greyLight;
  };
  for (const LightRequest& light : request.lights) {
    const bool hard = light.kind == LightKind::sun && light.shadow == SunShadow::hard;
    suns += hard ? 1 : 0;
    if (light.kind == LightKind::gradient)
      add(light.bands.size(), false);
    else if (light.kind != LightKind::head)
      add(hard ? 0 : 1, isGrey(light.color));
  }
  if (map) add(isGreyMap(*map) ? 1 : 3, isGreyMap(*map));
  if (request.bounces.value_or(0) != 0) fields += grey ? 1 : 3;
  if (suns > shader::kMostSuns)
    throw UsageError(
        fmt::format("--light: expected at most {} suns with hard shadows, found {}", shader::kMostSuns, suns));
  if (fields > shader::kMostLightFields)
    throw UsageError(
        fmt::format("--light: expected at most {} swept channels of light (a gradient, a coloured map and coloured "
                    "reflections have three), found {}",
                    shader::kMostLightFields, fields));
}

/// Nothing is kept where a single sweep answers it all.
SurfaceRays::Orders ordersFor(const LightingRequest& request, bool mapped) {
  const std::size_t lights = request.lights.size() + (mapped ? 1 : 0);
  const bool single = lights <= 1 && request.bounces.value_or(0) == 0 && request.opacity.value_or(1) == 1 &&
                      !request.thickness && !request.bent;
  return single ? SurfaceRays::Orders::remade : SurfaceRays::Orders::kept;
}

}  // namespace

std::size_t SweptLighting::bytes() const {
  std::size_t bytes = 0;
  for (const SweptLight& field : fields) bytes += field.values.bytes();
  if (thickness) bytes += thickness->values.bytes();
  if (bent)
    for (const SurfaceField& component : *bent) bytes += component.bytes();
  return bytes;
}

SweptLighting sweepLighting(const LightingRequest& request, const OrdinateOptions& ordinates, const EnvironmentMap* map,
                            const SweptScene& scene, const Camera& camera, glm::vec3 albedo) {
  checkCounts(request, map, albedo);
  LightingSweep sweep(request, ordinates, scene, camera, ordersFor(request, map != nullptr));
  if (request.lights.empty() && !map) sweep.addWhiteSky(glm::vec3(std::exp2(static_cast<float>(request.exposure))));
  for (const LightRequest& light : request.lights) sweep.addLight(light);
  if (map) sweep.addMap(*map);
  if (const int bounces = request.bounces.value_or(0); bounces != 0) sweep.addReflections(bounces, albedo);
  if (request.thickness) sweep.addThickness();
  if (request.bent) sweep.addBentNormals();
  return sweep.take();
}

SweptLighting sweepEvenSky(const TransportOptions& transport, double exposure, const SweptScene& scene) {
  SweptLighting swept;
  swept.fields.push_back({sweepTransport(scene.surface.level.view(), scene.swept.distance.view(), transport), 1});
  swept.uses.push_back({.values = {}, .full = 1});
  swept.colors.push_back(glm::vec3(static_cast<float>(std::exp2(exposure))));
  return swept;
}

}  // namespace isolume
