// The inner loops of the plane pass (plane_pass.h), in SIMD.
#pragma once

#include "padded_plane.h"

namespace isolume {

/// Step 1 for row y of `plane`, which holds the samples' own offsets: candidates from `before`, which lies at step dz.
/// Writes the result to `plane` and to `copy`.
void takeFromPlane(const PaddedPlane& before, float dz, glm::vec3 step, int nx, int y, PaddedPlane& plane,
                   PaddedPlane& copy);

/// One half of step 2: rows first, first + dy, ... (`count` of them) each take candidates from the row before, y - dy.
void takeFromRows(PaddedPlane& plane, glm::vec3 step, int nx, int first, int dy, int count);

inline constexpr int kAlongGroups = 2;
/// The rest of step 2 and step 3 for up to kAlongGroups groups of kRowGroup rows from y on: the nearer of `plane` and
/// `other`, then along x.
void takeAlongRows(const PaddedPlane& other, float stepX, int nx, int y, int groups, PaddedPlane& plane);

/// squaredLength, square root, unit and sign for a run of samples: the distance, negative where level > 0. `out` may be
/// x.
void offsetsToDistance(const float* x, const float* y, const float* z, const float* level, float unit,
                       std::size_t count, float* out);

}  // namespace isolume
