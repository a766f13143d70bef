// The points of the flat caps at which ordinates are summed: the solid samples on the six faces of the grid, each with
// the normal of its face. One on an edge of the grid counts for both faces, one at a corner for three.
#pragma once

#include <cstdint>
#include <vector>

#include "ranked_bits.h"
#include "surface_field.h"

namespace isolume {

struct SurfaceFoot;

class CapFeet {
 public:
  /// 1/5 byte per sample of a face. Threaded.
  explicit CapFeet(const BitGrid& solid);

  /// Feet are numbered in the order of faces, then of samples, x fastest.
  std::size_t count() const;
  /// Of all faces, one after the other.
  int rows() const;
  std::size_t rowBegin(int row) const;  ///< number of its first foot, or the next
  /// Adds the feet of a row to `feet`.
  void addRow(int row, std::vector<SurfaceFoot>& feet) const;

  /// Marks where among the padded samples of a field caps hold a number: at solid samples and those beside them in the
  /// face. Threaded.
  void mark(BitGrid& padded) const;
  /// The value of each foot to its face, and to samples outside beside them the mean of those among the 8 around in the
  /// face. Threaded.
  void spread(const std::uint16_t* values, SurfaceField& field) const;

 private:
  /// Samples of a face as rows: along the first of its other axes, beside each other along the second.
  struct Face {
    GridFace face;
    glm::ivec3 size;   // of the grid
    RankedBits solid;  // a grid of one layer
    std::size_t first = 0;
    glm::ivec3 sample(int i, int row) const;
  };
  static Face faceOfSolid(const BitGrid& solid, GridFace face);
  static std::uint16_t meanAround(const Face& face, const std::uint16_t* values, int i, int row);
  // visit(face, row), of the face, for a row of all faces.
  template <class Visit>
  void atRow(int row, const Visit& visit) const;
  // visit(face, row, near) for all rows of all faces: near, the samples that hold a number. Threaded.
  template <class Visit>
  void forEachRow(const Visit& visit) const;

  std::vector<Face> faces_;
};

}  // namespace isolume
