// The points of the flat caps at which ordinates are summed: the solid samples on the six faces of the grid, each with
// the normal of its face. One on an edge of the grid counts for both faces, one at a corner for three.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "surface_field.h"
#include "sweep/bit_grid.h"

namespace isolume {

struct SurfaceFoot;

class CapFeet {
 public:
  /// 8 bytes per row of a face. The solid samples are to be the same in every call.
  explicit CapFeet(const BitGrid& solid);

  std::size_t count() const { return count_; }
  /// In the order of faces, then of samples, x fastest. Threaded.
  void write(const BitGrid& solid, SurfaceFoot* feet) const;
  /// The value of each foot to its face, and to samples outside beside them the mean of those among the 8 around in the
  /// face. Threaded.
  void spread(const BitGrid& solid, const std::uint16_t* values, SurfaceField& field) const;

 private:
  /// Samples of a face as rows: along the first of its other axes, beside each other along the second.
  struct Rows {
    GridFace face;
    int along = 0, across = 1;
    glm::ivec3 at{0};
    int length = 0, rows = 0;
    std::vector<std::size_t> first;  // foot of each row
    glm::ivec3 sample(int i, int row) const;
    bool isSolid(const BitGrid& solid, int i, int row) const;
  };
  static void spreadRow(const BitGrid& solid, const Rows& rows, int row, const std::uint16_t* values,
                        SurfaceField& field);
  static void fillRow(const BitGrid& solid, const Rows& rows, int row, SurfaceField& field);

  std::array<Rows, kFaceCount> faces_;
  std::size_t count_ = 0;
};

}  // namespace isolume
