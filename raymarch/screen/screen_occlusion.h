// Openness from what the picture shows: the family of screen-space estimators, and everything that can be set of them.
//
// All of them ask the same G-buffer (depth and normal at the centre of each pixel, by the same sphere tracing as any
// other picture) about the neighbourhood of a surface point, a ball of radius R in world units, and differ in one GLSL
// function each (shaders/screen). What no pixel shows they cannot know: beyond the picture nothing is solid, and behind
// the surface that is seen everything is, or a given thickness.
//
//   crytek                the share of the ball that is outside, by points: 1/2 on a plane  [Mittring07]
//   hbao                  horizons, attenuated by 1 - r / R, no cosine of the normal        [Bavoil08]
//   gpu-sphere            O of mu(r) by points, evenly in the ball                          [SzirmayGpu] 4.1
//   gpu-hemisphere        the same in its half above the tangent plane                      [SzirmayGpu] 4.2
//   gpu-importance        random directions by the cosine, distances by d mu / dr           [SzirmayGpu] 4.3
//   gpu-tangent           points evenly in the tangent sphere, for the cosine               [SzirmayGpu] 4.4
//   gpu-disk              pipes across the ball, mu = (r / R)^4                             [SzirmayGpu] 4.5
//   szirmay10-containment gpu-importance with Poisson-disk samples                          [Szirmay10] Eq. 5
//   szirmay10-volumetric  the share of the tangent sphere that is outside, by pipes         [Szirmay10] Eq. 7
//   loos10-point          the share of the ball, or its upper half, by weighed points       [Loos10] Sec. 4
//   loos10-line           the same by lines                                                 [Loos10] Sec. 4.1
//   loos10-area           the same by lines that know how depths spread around them         [Loos10] Sec. 4.2
//   ssdo                  directions evenly, times the cosine; distances evenly: mu = r / R [Ritschel09]
//   gtao                  horizons with the cosine; every occluder within R counts          [Jimenez16]
//   bitmask               the same in sectors, with a thickness                             [Therrien23]
//   klehm11               bent normals and cones beside openness, by one of these           [Klehm11]
//     crytek-2d             points of the disk in the tangent plane: closed by what is seen above that plane
//     crytek-3d             points of the half ball, with steps on the way: mu = (r / R)^3, no cosine
//     hbao                  as hbao; what it closes of a hemisphere has its mean direction in closed form
//     sweep                 openness and mean open direction from the volume (sweep/ordinates), no neighbourhood
//   env-importance        directions by the sky's luminance times the cosine, open or not within R
// Light: openness under an even sky, unless a sky is given (sky_cube.h). Under it klehm11 looks up what its bent normal
// or cone receives (bent_light.glsl); ssdo and env-importance sum the radiance from where it is open; no other
// estimator takes one. gpu-tangent departs from the paper, whose sum is 2 * integral of mu over [0, 1] on an open plane
// (1/2 for mu = r^3, 1 for mu = r): here it is divided by that.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "raymarch/screen/sky_cube.h"
#include "sweep/reference/membership.h"

namespace isolume {

enum class ScreenEstimator {
  crytek,
  hbao,
  gpuSphere,
  gpuHemisphere,
  gpuImportance,
  gpuTangent,
  gpuDisk,
  szirmayContainment,
  szirmayVolumetric,
  loosPoint,
  loosLine,
  loosArea,
  ssdo,
  gtao,
  bitmask,
  klehm11,
  envImportance,
};
inline constexpr int kScreenEstimators = 17;

/// What klehm11 takes openness and mean open direction from.
enum class BentSource { crytek2d, crytek3d, hbao, sweep };

/// What klehm11 looks the sky up by; the values are those of shaders/screen/bent_light.glsl.
enum class BentLight {
  none,    ///< the normal: openness alone, the baseline of the paper
  normal,  ///< the bent normal
  cone,    ///< the bent cone, with the paper's angle
  cap,     ///< the bent cone whose cap has that mean direction: closer to the truth where light changes sharply
};
/// Whether it looks the sky up within a cone.
inline bool hasCone(BentLight light) { return light == BentLight::cone || light == BentLight::cap; }

/// Which points are outside ([Szirmay10] Fig. 2); the values are those of shaders/screen/characteristic.glsl.
enum class Characteristic {
  zBuffer,      ///< in front of what the picture shows
  heightField,  ///< above the highest solid of its column, along the grid's z axis
  implicit,     ///< by the volume itself
};

inline constexpr int kMostScreenSamples = 256;
inline constexpr int kMostInterleaving = 8;
inline constexpr int kMostScreenSteps = 3;

struct ScreenOcclusion {
  ScreenEstimator estimator = ScreenEstimator::szirmayVolumetric;
  double radiusWorld = 1;  ///< > 0
  int samples = 12;  ///< per pixel, 1 to kMostScreenSamples; hbao, gtao and bitmask: at least 4, see marchCounts()
  Membership membership = Membership::volumetric;  ///< where the estimator leaves it open: readsMembership()
  Characteristic surface = Characteristic::zBuffer;
  int interleaving = 4;             ///< side of the pattern of pixels with sets of their own; 1: all have the same
  bool filter = true;               ///< mean over the pattern, within a surface; nothing to do without a pattern
  bool normalisedBySamples = true;  ///< the sampled volume in place of the exact one ([Szirmay10] below Eq. 7)
  bool clampedToTangent = true;     ///< loos10: half the ball, above the tangent plane ([Loos10] Sec. 4.4)
  std::optional<double> thicknessWorld = {};  ///< z-buffer: solids end that far behind what is seen; none: never
  bool indirect = false;  ///< what is closed receives the neighbourhood's mean radiance ([SzirmayGpu] Sec. 2)
  std::optional<double> secondRadius = {};  ///< loos10: the product with that of another radius, in radii
  BentSource bentFrom = BentSource::crytek3d;
  BentLight bent = BentLight::cone;
  bool geometricTerm = false;  ///< cone, cap: with the heuristic of [Klehm11] Sec. 3.4
  int steps =
      3;  ///< klehm11 by crytek-3d, env-importance: further points on the way to each sample, 0 to kMostScreenSteps
  std::shared_ptr<const SkyCube> sky = {};  ///< none: an even one of radiance 1
};

const char* screenEstimatorName(ScreenEstimator estimator);
const char* bentSourceName(BentSource source);
const char* bentLightName(BentLight light);
std::array<ScreenEstimator, kScreenEstimators> screenEstimators();

/// Whether the estimator asks a characteristic function: those that march from horizon to horizon know pixels alone.
bool readsCharacteristic(const ScreenOcclusion& settings);
bool readsThickness(const ScreenOcclusion& settings);
/// Whether it tells where light comes from, and so takes a sky.
bool readsSky(ScreenEstimator estimator);
/// Whether it looks at the neighbourhood: klehm11 by sweeps reads one place of the volume.
bool readsNeighbourhood(const ScreenOcclusion& settings);
/// Whether it tests points on the way to its samples.
bool readsSteps(const ScreenOcclusion& settings);
/// The membership functions that it takes; none where mu is its own.
std::vector<Membership> takenMemberships(ScreenEstimator estimator);
/// Whether its sum is divided by a volume (or a light) that is known exactly as well as by the samples.
bool readsNormalisation(ScreenEstimator estimator);
bool isLoos10(ScreenEstimator estimator);

}  // namespace isolume
