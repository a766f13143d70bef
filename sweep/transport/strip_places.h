// The points at which light is read, by the strips and planes that a sweep passes.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "openness_transport.h"
#include "place_reader.h"

namespace isolume {

/// `offset` voxels above each point along its normal, within the grid.
std::vector<FixedPlace> fixedPlaces(const std::vector<OpenPoint>& points, double offset, glm::ivec3 size);

struct NumberedPlace {
  FixedPlace place;
  std::uint32_t number = 0;
};

/// Places of a block of rows, counted in the order of a sweep that runs up or down in y, between two planes. A place
/// between the rows of two blocks is in both. 24 bytes for each place, 4 for each block and plane.
class StripPlaces {
 public:
  StripPlaces(const std::vector<FixedPlace>& places, glm::ivec3 size, int blockRows, int sweepY);

  /// Those that lie between planes z and z + 1.
  const NumberedPlace* begin(int block, int z) const { return places_.data() + first_[indexOf(block, z)]; }
  const NumberedPlace* end(int block, int z) const { return places_.data() + first_[indexOf(block, z) + 1]; }

 private:
  std::size_t indexOf(int block, int z) const {
    return static_cast<std::size_t>(block) * static_cast<std::size_t>(planes_) + static_cast<std::size_t>(z);
  }
  int planes_;
  std::vector<std::uint32_t> first_;
  std::vector<NumberedPlace> places_;
};

}  // namespace isolume
