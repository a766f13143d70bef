// What the reference estimates at a point of the surface, one sample at a time.
//
// With V(w) = 1 where the ray towards w meets nothing, N the normal and L(w) the radiance from w, in world space:
//   ambient      O = (1 / pi) * integral of mu(D(w)) cos dw    openness; mu = V without a radius (membership.h)
//   shadow       V(l) and V(l) max(N . l, 0)                   hard shadow from the light's direction l; one ray, exact
//   light        the same two averaged over a disc of light    uniform over the cap of that angular radius about l
//   environment  E / pi = (1 / pi) * integral of L V cos dw    a white map gives the openness, to the last bit
//   bounce       E / pi with L where nothing is met, and albedo times the E / pi of the point that is met where a path
//                of at most `bounces` reflections may go on: bounces = 0 is `environment`. Albedo 1 under a white sky
//                gives 1 wherever all paths escape in time (furnace test); in a closed cavity no path escapes, and deep
//                ones lose the paths that would have needed more reflections, so the result approaches the truth from
//                below.
//   bent         mean open direction, without a cosine         N_b = integral of V w dw / integral of V dw, [Klehm11]
//                Sec. 3.1, shown at unit length, and the cone C = (1 - max(0, 2 |N_b| - 1)) pi / 2 of Sec. 3.2 in
//                radians: an open point gives N and pi / 2. Eq. 2 of the paper puts 1 / pi before the integral, which
//                sets the length alone. Nothing open: direction 0, cone 0.
//   translucent  E / pi = (1 / pi) * integral over the whole sphere of |N . w| T(w) dw, [Singh10] Sec. 4.2: light that
//                goes straight through. T = exp(-s l) with l the length inside the solid on the way to the border of
//                the grid and s = -ln(1 - opacity) / h, h the smallest spacing: a voxel of solid lets 1 - opacity pass,
//                as in Eq. 8. Opacity 0 gives 2, opacity 1 the openness of `ambient` (T = V). Beside it the
//                mean length inside, (1 / pi) * integral over N . w < 0 of |N . w| l dw, world units.
// Directions are drawn with density cos / pi about the normal (bent: uniform), and for a map with bright spots half of
// them from the map, combined by the balance heuristic ([Veach95], one-sample form): the weight of a direction is
// (cos / pi) over the mixture of both densities. `translucent` takes two rays, a direction and its opposite.
// A normal that leans away from the surface (N of the smooth gradient) has directions that enter the solid at once:
// they count as blocked at distance 0, as everywhere in this program. Pure functions: thread-safe.
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <string>
#include <vector>

#include "sweep/reference/environment.h"
#include "sweep/reference/membership.h"
#include "sweep/reference/replicates.h"
#include "sweep/reference/surface_tracer.h"

namespace isolume {

enum class Integrand { ambient, shadow, light, environment, bounce, bent, translucent };

/// Which gradient the hemisphere stands on: SurfaceTracer::smoothGradient() or SurfaceTracer::cellGradient().
enum class ReferenceNormals { data, exact };

struct IntegrandSettings {
  Integrand integrand = Integrand::ambient;
  ReferenceNormals normals = ReferenceNormals::data;
  std::optional<double> radiusWorld;  ///< ambient: unlimited without, > 0
  Membership membership = Membership::classical;
  glm::dvec3 lightDirection{0, 0, 1};        ///< world, towards the light, any length but 0
  double lightRadiusDegrees = 0;             ///< light: angular radius, (0, 90]
  const Environment* environment = nullptr;  ///< environment, bounce: borrowed; none is a uniform white sky
  int bounces = 0;                           ///< bounce: reflections by the surface, >= 0
  glm::dvec3 albedo{1};                      ///< bounce: linear, [0, 1]
  double opacity = 1;                        ///< translucent: of a voxel of solid, [0, 1]
};

/// The volume and how its axes lie in the world (orthonormal; may mirror). The spacing is that of the level.
struct ReferenceScene {
  const SurfaceTracer& tracer;
  glm::dmat3 worldFromAxes{1};
};

/// A point of the surface with the normal that it is shaded with: unit, along the grid's axes, out of the solid.
struct ShadedPoint {
  SurfacePoint hit;
  glm::dvec3 normal{0, 0, 1};
};

/// The normal at a hit. On a cap that of the face; where there is no gradient (a flat spot) `viewer`, a unit vector.
glm::dvec3 shadingNormal(const SurfaceTracer& tracer, const SurfacePoint& hit, ReferenceNormals normals,
                         glm::dvec3 viewer);

/// Whether one sample is enough: the integrand has no integral.
inline bool isExact(Integrand integrand) { return integrand == Integrand::shadow; }

/// Sample `index` of the sequence of that key (low_discrepancy.h): what the means of the channels estimate.
Channels sampleIntegrand(const ReferenceScene& scene, const IntegrandSettings& settings, const ShadedPoint& point,
                         std::uint64_t key, std::uint32_t index);

/// From means of channels to what is shown (bent: a quotient; all others: the means themselves).
Channels shownChannels(Integrand integrand, const Channels& mean);

/// Names of the channels shown, as they stand in a picture: "ambient.Y"; "shadow.Y", "direct.Y"; "irradiance.R" ".G"
/// ".B"; "bent.X" ".Y" ".Z", "cone.Y"; "translucent.Y", "thickness.Y".
std::vector<std::string> channelNames(Integrand integrand);

}  // namespace isolume
