// The eight octants as data: one table drives the distance sweep, the visibility sweep and the geometry-term tables.
//
// [Singh10] Table 1 numbers the sweeps s = 1 to 8; here index = s - 1. Sweep s visits voxels in direction `sweep`, and
// what it carries is the visibility of the opposite octant of directions, `towardsLight` = -sweep ([Singh10] Sec. 2).
// Octants 0 to 3 and 4 to 7 differ only in the sign of z: octant s and s ^ 4 mirror each other in z.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <string_view>

namespace isolume {

inline constexpr int kOctantCount = 8;

struct Octant {
  glm::ivec3 sweep;       ///< signs of the traversal, [Singh10] Table 1
  std::string_view name;  ///< signs of the directions that the octant's light comes from: "nnn" for (-,-,-)
  constexpr glm::ivec3 towardsLight() const { return -sweep; }
};

inline constexpr std::array<Octant, kOctantCount> kOctants{{
    {{1, 1, 1}, "nnn"},
    {{-1, 1, 1}, "pnn"},
    {{1, -1, 1}, "npn"},
    {{-1, -1, 1}, "ppn"},
    {{1, 1, -1}, "nnp"},
    {{-1, 1, -1}, "pnp"},
    {{1, -1, -1}, "npp"},
    {{-1, -1, -1}, "ppp"},
}};

}  // namespace isolume
