// Where a sweep writes an octant's visibility.
#pragma once

#include <cstdint>

namespace isolume {

/// At most one of the two is set; neither: the visibility is not swept.
struct VisibilityTarget {
  std::uint8_t* as8 = nullptr;  ///< round(255 V), one byte per voxel
  float* asFloat = nullptr;
  bool wanted() const { return as8 != nullptr || asFloat != nullptr; }
};

}  // namespace isolume
