// The lights that were asked for.
//
// Units: a light of intensity 1 and colour white shows a surface in its own colour where it falls straight and nothing
// is in its way (E / pi = 1). Colours are multiplied with the albedo. World axes, z up.
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "raymarch/camera.h"
#include "src/jobs/occlusion_method.h"
#include "sweep/occlusion_sweep.h"

namespace isolume {

enum class LightKind {
  sky,       ///< the same radiance from everywhere
  gradient,  ///< a sky of three bands: zenith, horizon, ground
  sun,       ///< a disc at the sky
  head,      ///< from the eye, without shadow
  octants,   ///< the eight octants of the grid's axes ([Singh10]), each with an intensity of its own
};

enum class SunShadow {
  soft,    ///< by ordinates over its disc; with octants, the one octant that it stands in ([Singh10] Fig. 8)
  hard,    ///< a ray in the shader
  turned,  ///< one octant on a grid that is turned towards it ([Singh10] Sec. 4.1)
};

/// One --light.
struct LightRequest {
  std::string text;  ///< as given
  LightKind kind = LightKind::sky;
  glm::vec3 color{1};                                                        ///< linear, with the intensity
  std::array<glm::vec3, 3> bands{glm::vec3(1), glm::vec3(1), glm::vec3(1)};  ///< gradient: zenith, horizon, ground
  std::optional<glm::dvec3> direction;               ///< sun: towards it, world; instead of angles
  double azimuthDegrees = 0, elevationDegrees = 45;  ///< sun: where it stands, as a camera's (raymarch/camera.h)
  bool fromCamera = false;                           ///< sun: angles from the eye: to the right, and up
  SunShadow shadow = SunShadow::soft;
  std::array<float, kOctantCount> octants = kEvenOctants;  ///< octants: of sweep/octants.h
  std::optional<double> radiusDegrees;  ///< sun: angular radius, (0, 90], of a soft shadow; default kSunDegrees
};

struct LightingRequest {
  std::vector<LightRequest> lights;  ///< none, and no map: a white sky
  std::string environment;           ///< file of a map, or ""
  std::optional<double> rotationDegrees;
  double exposure = 0;            ///< doublings of all light
  std::optional<int> bounces;     ///< reflections by the surface; kAllBounces: until nothing changes; default 0
  std::optional<double> opacity;  ///< of a voxel of solid, [0, 1]; default 1
  /// In place of an opacity: the mean free path in the solid as a share of its extent (the diagonal of its box).
  std::optional<double> freePathShare;
  bool bent = false;       ///< bent normals are wanted
  bool thickness = false;  ///< the thickness is wanted
};
inline constexpr int kAllBounces = -1;
inline constexpr double kSunDegrees = 1;
/// Light comes through a finger of the solid, and hardly through its body.
inline constexpr double kTranslucentShare = 0.03;

/// Whether light is openness and nothing else: one white sky, no reflection, an opaque solid.
bool isPlain(const LightingRequest& request);

/// The first option that asks for more than an even white sky of any exposure, or nullptr.
const char* beyondEvenSky(const LightingRequest& request);

/// Whether light comes through the solid.
bool isTranslucent(const LightingRequest& request);

/// UsageError for options that contradict each other or the method of occlusion.
void checkLighting(const LightingRequest& request, OcclusionMethod method);

/// Towards a sun, world, unit. Angles are those of a camera in the world, or of the eye `camera`.
glm::dvec3 sunDirection(const LightRequest& sun, const CameraAxes& camera);

/// What the request comes to with eight octants of the grid's axes: a sun is the octant that it stands in.
std::array<glm::vec3, kOctantCount> octantLights(const LightingRequest& request, glm::dmat3 worldFromAxes,
                                                 const CameraAxes& camera);

/// Of grey octants, which need neither grid nor camera: what OcclusionMethod::combined sweeps.
OctantIntensities combinedIntensities(const LightingRequest& request);

/// The first option that was given, or nullptr.
const char* givenOption(const LightingRequest& request);

/// As options of the command line; lists are arrays.
nlohmann::ordered_json lightingSettings(const LightingRequest& request);

}  // namespace isolume
