// How much of a grid a distance field covers exactly.
#pragma once

namespace isolume {

/// Exact everywhere, or only within a band around the surface, with a safe lower bound of the magnitude beyond.
enum class DistanceExtent { full, band };

}  // namespace isolume
