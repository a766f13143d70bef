// The inner loops of the plane pass (plane_pass.h), in SIMD.
#pragma once

#include <array>
#include <cstdint>

#include "padded_plane.h"

namespace isolume {

/// A row of the field: one bit for each sample that is fixed, and the offsets, of which only theirs are read.
struct FixedRow {
  const std::uint64_t* bits = nullptr;
  std::array<float*, 3> component{};
};

/// Step 1 for row y of `plane`: the offsets of the fixed samples, and candidates from `before`, which lies at step dz
/// (null: there is none).
void takeFromPlane(const FixedRow& fixed, const PaddedPlane* before, float dz, glm::vec3 step, int nx, int y,
                   PaddedPlane& plane);

/// One half of step 2: rows first, first + dy, ... (`count` of them) each take candidates from the row before, y - dy.
void takeFromRows(PaddedPlane& plane, glm::vec3 step, int nx, int first, int dy, int count);

/// kRowGroup rows from y on as columns of `to`, of which the first two components are swapped.
void transposeRows(const PaddedPlane& from, int nx, int y, PaddedPlane& to);

/// Steps 4 and 5 for row y of `plane`.
enum class Result {
  kept,      ///< the squared length of what is not fixed
  compared,  ///< the distance by the shorter of the one kept and this one
  alone      ///< the distance by this one
};
/// Over the row's first components; `level` and `unit` as of offsetsToDistance().
void finishRow(const FixedRow& fixed, Result result, const float* level, float unit, int nx, int y, PaddedPlane& plane);

/// squaredLength, square root, unit and sign for a run of samples: the distance, negative where level > 0. `out` may be
/// x.
void offsetsToDistance(const float* x, const float* y, const float* z, const float* level, float unit,
                       std::size_t count, float* out);

}  // namespace isolume
