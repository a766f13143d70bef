// Numbers at the surface of a grid, to be interpolated at its points.
//
// Where a face of the grid cuts the solid, the isosurface meets a flat cap at an edge, and a sample there has two
// answers: one for the isosurface, which the cap would make too open, and one for the cap. So there is a number for
// each sample next to the isosurface, and beyond each face of the grid a layer of numbers for the samples of that face
// next to its cap; elsewhere 0. On corner (256^3, 512 ordinates) that takes the RMSE of openness from .0129 to .0091.
//
// At a point of the isosurface the corners of its cell count by their trilinear weights, times how far the gradient at
// the corner agrees with the normal at the point, cos and at least kLeastAgreement: of a sheet thinner than a voxel or
// a sharp rim one sample serves both sides, and the wrong side would show through (gyroid, 256^3: .0186 to .0141;
// cranium: .0289 to .0214). shaders/march/light_at.glsl does the same.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "ranked_bits.h"
#include "sweep/grid.h"

namespace isolume {

inline constexpr double kLeastAgreement = 0.02;

/// A face of the grid.
struct GridFace {
  int axis = 0, side = 0;  ///< side 0 at the first samples, 1 at the last
};
inline constexpr int kFaceCount = 6;
inline GridFace faceOf(int i) { return {i / 2, i % 2}; }
/// Where its samples stand along its axis.
inline int placeOf(GridFace face, glm::ivec3 size) { return face.side == 0 ? 0 : size[face.axis] - 1; }

/// Move-only. Thread-safe for reading, and for writing different numbers.
class SurfaceField {
 public:
  SurfaceField() = default;
  /// A number at every sample and cap of a grid of `size`, all 0: 2 bytes for each, and for each of a shell around
  /// them. Threaded.
  explicit SurfaceField(glm::ivec3 size);
  /// Numbers at the members of a set alone, uninitialised: 2 bytes for each, and the set (ranked_bits.h). It is of the
  /// padded grid: sample (x, y, z) stands at (x + 1, y + 1, z + 1), and the caps in the layers around.
  explicit SurfaceField(RankedBits held);

  bool empty() const { return !numbers_; }
  glm::ivec3 size() const { return padded_ - 2; }
  glm::ivec3 paddedSize() const { return padded_; }
  std::size_t bytes() const;

  /// The numbers that are held, in the order of the padded samples: x fastest, then y, then z.
  std::span<std::uint16_t> numbers() { return {numbers_.get(), count_}; }
  std::span<const std::uint16_t> numbers() const { return {numbers_.get(), count_}; }
  /// 0 where none is held.
  std::uint16_t padded(glm::ivec3 at) const { return holds(at) ? numbers_[placeOf(at)] : std::uint16_t{0}; }
  std::uint16_t wall(glm::ivec3 at) const { return padded(at + 1); }
  /// `at` on that face.
  std::uint16_t cap(GridFace face, glm::ivec3 at) const { return padded(beyond(face, at)); }

  /// Of samples that hold a number.
  std::uint16_t& wall(glm::ivec3 at) { return held(at + 1); }
  std::uint16_t& cap(GridFace face, glm::ivec3 at) { return held(beyond(face, at)); }

  /// Where in numbers() that of a padded sample stands, or the next if it holds none.
  std::size_t placeOf(glm::ivec3 at) const {
    if (held_) return held_->number(at);
    const glm::vec<3, std::size_t> size(padded_), place(at);
    return (place.z * size.y + place.y) * size.x + place.x;
  }
  /// All of a row of the padded samples, paddedSize().x numbers.
  void copyRow(int y, int z, std::uint16_t* to) const;
  /// Layers [begin, end) of the padded samples, one after the other. Threaded.
  void copyLayers(int begin, int end, std::uint16_t* to) const;

  /// Where the cap of sample `at` of a face stands among the padded samples.
  static glm::ivec3 beyond(GridFace face, glm::ivec3 at) {
    at[face.axis] += face.side == 0 ? -1 : 1;
    return at + 1;
  }

 private:
  bool holds(glm::ivec3 at) const { return !held_ || held_->test(at); }
  std::uint16_t& held(glm::ivec3 at) {
    assert(holds(at));
    return numbers_[placeOf(at)];
  }

  glm::ivec3 padded_{0};
  std::optional<RankedBits> held_;  // none: every sample
  std::size_t count_ = 0;
  LargeArray<std::uint16_t> numbers_;
};

/// A number for every sample as a field: caps hold what their samples do. Threaded.
SurfaceField surfaceField(GridView<const std::uint16_t> samples);

/// A number per sample: that of the cap (the mean, where faces meet) at samples inside on the border, else that of the
/// isosurface. 2 bytes per voxel. Threaded.
Grid<std::uint16_t> bySample(const SurfaceField& field, GridView<const float> level);

/// At a point of the isosurface within the grid, index space; `normal` unit, along the grid's axes. At least two
/// samples along each axis.
double wallValueAt(const SurfaceField& field, GridView<const float> level, glm::dvec3 position, glm::dvec3 normal);
/// At a point of a cap, bilinear.
double capValueAt(const SurfaceField& field, GridFace face, glm::dvec3 position);
/// At a point of the surface whose normal is not known, trilinear: on the border that of the cap, where there is one.
double surfaceValueAt(const SurfaceField& field, glm::dvec3 position);

}  // namespace isolume
