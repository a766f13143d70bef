#include "cap_feet.h"

#include <utility>

#include "surface_feet.h"
#include "sweep/near_sets.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

int axisAlong(GridFace face) { return face.axis == 0 ? 1 : 0; }
int axisAcross(GridFace face) { return face.axis == 2 ? 1 : 2; }

}  // namespace

glm::ivec3 CapFeet::Face::sample(int i, int row) const {
  glm::ivec3 sample(placeOf(face, size));
  sample[axisAlong(face)] = i;
  sample[axisAcross(face)] = row;
  return sample;
}

CapFeet::Face CapFeet::faceOfSolid(const BitGrid& solid, GridFace face) {
  const glm::ivec3 size = solid.size();
  BitGrid bits(glm::ivec3(size[axisAlong(face)], size[axisAcross(face)], 1));
  const int place = placeOf(face, size);
  parallelFor(static_cast<std::size_t>(bits.size().y), [&](std::size_t at) {
    const int row = static_cast<int>(at);
    if (face.axis != 0) {
      std::copy_n(face.axis == 1 ? solid.row(place, row) : solid.row(row, place), bits.words(), bits.row(row, 0));
      return;
    }
    for (int y = 0; y < size.y; ++y)
      if (solid.test(place, y, row)) bits.mark(y, row, 0);
  });
  return {face, size, RankedBits(std::move(bits)), 0};
}

CapFeet::CapFeet(const BitGrid& solid) {
  std::size_t count = 0;
  for (int f = 0; f < kFaceCount; ++f) {
    faces_.push_back(faceOfSolid(solid, faceOf(f)));
    faces_.back().first = count;
    count += faces_.back().solid.count();
  }
}

std::size_t CapFeet::count() const { return faces_.back().first + faces_.back().solid.count(); }

int CapFeet::rows() const {
  int rows = 0;
  for (const Face& face : faces_) rows += face.solid.size().y;
  return rows;
}

template <class Visit>
void CapFeet::atRow(int row, const Visit& visit) const {
  for (const Face& face : faces_) {
    if (row < face.solid.size().y) {
      visit(face, row);
      return;
    }
    row -= face.solid.size().y;
  }
}

std::size_t CapFeet::rowBegin(int row) const {
  std::size_t begin = 0;
  atRow(row, [&](const Face& face, int own) { begin = face.first + face.solid.number({0, own, 0}); });
  return begin;
}

void CapFeet::addRow(int row, std::vector<SurfaceFoot>& feet) const {
  atRow(row, [&](const Face& face, int own) {
    glm::vec3 normal{0};
    normal[face.face.axis] = face.face.side == 0 ? -1.0F : 1.0F;
    const BitGrid& solid = face.solid.bits();
    forEachBit(solid.row(own, 0), solid.words(), [&](int i) {
      feet.push_back({glm::vec3(face.sample(i, own)), normal});
    });
  });
}

// The mean of the feet among the 8 samples around in the face.
std::uint16_t CapFeet::meanAround(const Face& face, const std::uint16_t* values, int i, int row) {
  unsigned sum = 0, count = 0;
  for (int k = 0; k < 9; ++k) {
    const glm::ivec3 at(i + k % 3 - 1, row + k / 3 - 1, 0);
    if (!face.solid.test(at)) continue;
    sum += values[face.first + face.solid.number(at)];
    ++count;
  }
  return static_cast<std::uint16_t>((sum + count / 2) / count);
}

template <class Visit>
void CapFeet::forEachRow(const Visit& visit) const {
  for (const Face& face : faces_) {
    if (face.solid.count() == 0) continue;
    const BitGrid& solid = face.solid.bits();
    parallelFor(static_cast<std::size_t>(solid.size().y), [&](std::size_t at) {
      BitRow near(static_cast<std::size_t>(solid.words()));
      grownRow(solid, Across::corners, static_cast<int>(at), 0, near);
      visit(face, static_cast<int>(at), near);
    });
  }
}

void CapFeet::mark(BitGrid& padded) const {
  forEachRow([&](const Face& face, int row, const BitRow& near) {
    forEachBit(near.data(), static_cast<int>(near.size()), [&](int i) {
      const glm::ivec3 at = SurfaceField::beyond(face.face, face.sample(i, row));
      padded.mark(at.x, at.y, at.z);
    });
  });
}

void CapFeet::spread(const std::uint16_t* values, SurfaceField& field) const {
  forEachRow([&](const Face& face, int row, const BitRow& near) {
    const std::uint16_t* next = values + face.first + face.solid.number({0, row, 0});
    forEachBit(near.data(), static_cast<int>(near.size()), [&](int i) {
      const bool own = face.solid.test({i, row, 0});
      field.cap(face.face, face.sample(i, row)) = own ? *next++ : meanAround(face, values, i, row);
    });
  });
}

}  // namespace isolume
