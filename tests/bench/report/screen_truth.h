// What each screen-space estimator approximates, by exact rays and exact points: the truth of report_screen.
#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "raymarch/screen/screen_occlusion.h"
#include "sweep/reference/reference.h"

namespace isolume::bench {

/// The integral of an estimator within a radius:
///   O of a membership function ([Szirmay10] Eq. 2): gpu-*, szirmay10-*, gtao, bitmask, env-importance;
///   the mean of min(D / R, 1) over all directions of the hemisphere, without the cosine: hbao;
///   the share of these that meet nothing within the radius: klehm11 by crytek-2d;
///   the share of the ball, or of its half above the tangent plane, that lies outside: crytek, loos10-*, klehm11 by crytek-3d.
enum class ScreenIntegral { membership, directions, openDirections, ball, halfBall };
struct ScreenTruth {
  ScreenIntegral integral = ScreenIntegral::membership;
  Membership membership = Membership::classical;  ///< of the first
  bool operator==(const ScreenTruth&) const = default;
};
ScreenTruth screenTruth(const ScreenOcclusion& settings);
std::string screenTruthName(const ScreenTruth& truth);

/// Per pixel, NaN where nothing is hit. `rays` samples each, a multiple of kReplicates.
std::vector<double> truthPicture(const ReferenceScene& scene, const std::vector<ReferencePixel>& hits,
                                 const ScreenTruth& truth, double radiusWorld, int rays);
/// Ambient occlusion, unlimited.
std::vector<double> ambientPicture(const ReferenceScene& scene, const std::vector<ReferencePixel>& hits, int rays);

}  // namespace isolume::bench
