// The points of the surface at which ordinates are summed: one for each outside sample with a solid one beside it along
// an axis, and those of the flat caps (cap_feet.h).
//
// A sample is next to the surface if any of the 26 around it lies on the other side: these are the corners of all cells
// that the surface crosses, all that an interpolation at a point of the surface reads. Each stands for the point of the
// surface closest to it, its foot: sample - D N with the distance D and the level's gradient as normal N. The other
// samples next to the surface have no sum of their own: they take what those with a sum around their foot hold, by
// trilinear weights. Each of them has one among the 26 around, since from a solid corner of its cell to an outside one
// the sign changes along some edge.
// That is a third to a quarter of the sums of one per sample, and costs .003 of RMSE where walls meet and nothing
// elsewhere (docs/occlusion-study.md).
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "cap_feet.h"
#include "foot_chunks.h"
#include "foot_rows.h"
#include "surface_field.h"
#include "sweep/bit_grid.h"

namespace isolume {

struct SurfaceFoot {
  glm::vec3 position{0};  ///< on the surface, index space
  glm::vec3 normal{0};    ///< unit, world units along the grid's axes, out of the solid; 0 at a flat spot
};

/// A sample next to the surface and the foot that it stands for.
struct NearSample {
  glm::ivec3 at{0};
  std::uint32_t foot = 0;
};

class SurfaceFeet {
 public:
  /// Borrows the fields for good. `distance` in world units, exact next to the surface. Threaded.
  /// Memory: 5/16 byte per voxel. Feet are not kept, but made from the fields each time that they are asked for.
  SurfaceFeet(GridView<const float> level, GridView<const float> distance);

  /// Feet are numbered: first those of the isosurface, in the order of the samples, x fastest, then y, then z; then
  /// those of the caps.
  std::size_t count() const { return outside_.count() + caps_.count(); }
  /// All of them, 24 bytes each. Threaded.
  std::vector<SurfaceFoot> makeFeet() const;
  /// The same in chunks of some thousands; borrows this. The chunks do not depend on the number of threads.
  FootChunks chunks() const;
  /// The samples with level > 0.
  const BitGrid& solid() const { return solid_; }

  /// Samples next to the surface, those inside or those outside, each with a foot close to it: its own if it is outside
  /// and has one, else that of a neighbour outside closest to its own place on the surface. 16 bytes each. Threaded.
  std::vector<NearSample> nearSamples(bool inside) const;

  /// Gives feet without a value (known[foot] = 0) the mean of those around them, samples apart by one along each axis,
  /// that have one; the others keep theirs.
  void fillUnknown(std::vector<std::uint16_t>& values, const std::vector<std::uint8_t>& known) const;

  /// The values of all feet as a field. With `known`, samples without a foot take nothing from those with known[foot] =
  /// 0 (on the far side of a thin wall, say): from what of the 26 around is known, or 0. Memory: that of the field
  /// (surface_field.h). Threaded.
  SurfaceField spread(const std::vector<std::uint16_t>& values, const std::vector<std::uint8_t>* known = nullptr) const;

 private:
  std::size_t partBegin(int part) const;
  void addPart(int part, std::vector<SurfaceFoot>& feet) const;
  bool isSolid(glm::ivec3 at) const { return solid_.test(at.x, at.y, at.z); }
  std::uint32_t nearestFoot(glm::ivec3 at, glm::vec3 place) const;
  BitGrid given(const std::vector<std::uint8_t>& known) const;
  RankedBits held() const;
  static std::uint16_t meanAround(glm::ivec3 at, const FootValues& from);
  void spreadLayer(int z, const FootValues& from, SurfaceField& field) const;
  template <class Visit>
  void forEachLayer(const Visit& visit) const;
  template <class Visit>
  static void forEachAround(glm::ivec3 at, const BitGrid& set, const Visit& visit);
  template <class Visit>
  void forEachFoot(int y, int z, const Visit& visit) const;

  FootFields fields_;
  BitGrid solid_;  // samples inside
  CapFeet caps_;
  RankedBits outside_;  // samples outside with a solid one beside them along an axis: they have feet
};

}  // namespace isolume
