// What a ray found, and what it took.
#pragma once

#include <glm/vec3.hpp>
#include <optional>

namespace isolume::bench {

/// A step is one place where the ray reads something to decide how far to go on; a solve is one cell whose cubic is
/// worked out there (every solve is also a step).
struct TracedRay {
  std::optional<glm::dvec3> found;  ///< index space
  int steps = 0, solves = 0;
};

}  // namespace isolume::bench
