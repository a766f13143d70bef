#include "cap_feet.h"

#include "surface_feet.h"
#include "sweep/parallel.h"

namespace isolume {

glm::ivec3 CapFeet::Rows::sample(int i, int row) const {
  glm::ivec3 sample = at;
  sample[along] = i;
  sample[across] = row;
  return sample;
}

// False beyond the face.
bool CapFeet::Rows::isSolid(const BitGrid& solid, int i, int row) const {
  const glm::ivec3 place = sample(i, row);
  return solid.test(place.x, place.y, place.z);
}

CapFeet::CapFeet(const BitGrid& solid) {
  for (int f = 0; f < kFaceCount; ++f) {
    Rows& rows = faces_[static_cast<std::size_t>(f)];
    rows.face = faceOf(f);
    rows.along = rows.face.axis == 0 ? 1 : 0;
    rows.across = rows.face.axis == 2 ? 1 : 2;
    rows.at[rows.face.axis] = placeOf(rows.face, solid.size());
    rows.length = solid.size()[rows.along];
    rows.rows = solid.size()[rows.across];
    rows.first.resize(static_cast<std::size_t>(rows.rows));
    parallelFor(rows.first.size(), [&](std::size_t row) {
      for (int i = 0; i < rows.length; ++i) rows.first[row] += rows.isSolid(solid, i, static_cast<int>(row)) ? 1 : 0;
    });
    for (std::size_t& first : rows.first) {
      const std::size_t own = first;
      first = count_;
      count_ += own;
    }
  }
}

void CapFeet::write(const BitGrid& solid, SurfaceFoot* feet) const {
  for (const Rows& rows : faces_) {
    glm::vec3 normal{0};
    normal[rows.face.axis] = rows.face.side == 0 ? -1.0F : 1.0F;
    parallelFor(rows.first.size(), [&](std::size_t at) {
      SurfaceFoot* next = feet + rows.first[at];
      const auto row = static_cast<int>(at);
      for (int i = 0; i < rows.length; ++i)
        if (rows.isSolid(solid, i, row)) *next++ = {glm::vec3(rows.sample(i, row)), normal};
    });
  }
}

void CapFeet::spreadRow(const BitGrid& solid, const Rows& rows, int row, const std::uint16_t* values,
                        SurfaceField& field) {
  const std::uint16_t* next = values + rows.first[static_cast<std::size_t>(row)];
  for (int i = 0; i < rows.length; ++i)
    if (rows.isSolid(solid, i, row)) field.cap(rows.face, rows.sample(i, row)) = *next++;
}

void CapFeet::fillRow(const BitGrid& solid, const Rows& rows, int row, SurfaceField& field) {
  for (int i = 0; i < rows.length; ++i) {
    if (rows.isSolid(solid, i, row)) continue;
    unsigned sum = 0, count = 0;
    for (int k = 0; k < 9; ++k) {
      const int beside = i + k % 3 - 1, other = row + k / 3 - 1;
      if (beside < 0 || other < 0 || beside >= rows.length || other >= rows.rows || !rows.isSolid(solid, beside, other))
        continue;
      sum += field.cap(rows.face, rows.sample(beside, other));
      ++count;
    }
    if (count > 0) field.cap(rows.face, rows.sample(i, row)) = static_cast<std::uint16_t>((sum + count / 2) / count);
  }
}

void CapFeet::spread(const BitGrid& solid, const std::uint16_t* values, SurfaceField& field) const {
  for (const Rows& rows : faces_) {
    const auto count = static_cast<std::size_t>(rows.rows);
    parallelFor(count, [&](std::size_t row) { spreadRow(solid, rows, static_cast<int>(row), values, field); });
    parallelFor(count, [&](std::size_t row) { fillRow(solid, rows, static_cast<int>(row), field); });
  }
}

}  // namespace isolume
