// How open a ray is that meets the solid at distance D: the fuzzy membership functions mu(D) of [Szirmay10] Fig. 3.
//
// Openness (the paper's "ambient occlusion") is O = (1 / pi) * integral over the hemisphere of mu(D) cos(theta) dw,
// [Szirmay10] Eq. 2: mu grows from 0 at the surface to 1 where an occluder no longer counts, so O = 1 is open.
//   exponential  1 - exp(-D / R)   Fig. 3 (a), with the absorption coefficient tau = 1 / R; never ends: rays go all the
//                                  way, and R is the distance at which mu = 1 - 1/e
//   classical    0 for D < R       Fig. 3 (b): every occluder nearer than R counts in full
//   squareRoot   sqrt(D / R)       Fig. 3 (c), "localized square root"
//   linear       D / R             Fig. 3 (d)
//   volumetric   (D / R)^3         Fig. 3 (e): its derivative is proportional to r^2, which makes O a volume; the
//                                  figure's axis calls it cubic
// All but the first are 1 from R on. D and R in the same unit, R > 0. D = infinity (nothing met) gives 1.
#pragma once

#include <cmath>

namespace isolume {

enum class Membership { exponential, classical, squareRoot, linear, volumetric, quartic };

/// Whether mu = 1 from R on, so that rays may end there.
inline bool isLocal(Membership membership) { return membership != Membership::exponential; }

/// mu at `share` = D / R >= 0.
inline double membershipAt(Membership membership, double share) {
  if (membership == Membership::exponential) return -std::expm1(-share);
  if (share >= 1) return 1;
  switch (membership) {
    case Membership::squareRoot:
      return std::sqrt(share);
    case Membership::linear:
      return share;
    case Membership::volumetric:
      return share * share * share;
    case Membership::quartic:
      return share * share * share * share;
    default:
      return 0;
  }
}

}  // namespace isolume
