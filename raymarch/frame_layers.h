// The layers of a frame from what the GPU writes.
#pragma once

#include <glm/vec4.hpp>
#include <vector>

#include "renderer.h"
#include "view.h"

namespace isolume {

/// Each row-major, top row first: normals along the grid's axes, positions in index space with w > 0 where something is
/// hit, light. From there to the world in double. Threaded over rows.
void fillLayers(Frame& frame, const std::vector<glm::vec4>& normals, const std::vector<glm::vec4>& positions,
                const std::vector<glm::vec4>& lights, const Camera& camera, const GridFrame& grid);

}  // namespace isolume
