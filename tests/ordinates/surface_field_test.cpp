// Fields at the surface: what a point reads of the samples around it.
#include "sweep/ordinates/surface_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/vector_relational.hpp>
#include <utility>
#include <vector>

#include "ordinates/swept_openness.h"
#include "support/random_grids.h"
#include "support/test_levels.h"
#include "sweep/closest/closest_distance.h"
#include "sweep/ordinates/surface_feet.h"

namespace isolume {
namespace {

constexpr std::uint16_t kWall = 1000, kCap = 60000;

TEST(SurfaceField, KeepsCapsAndWallsApart) {
  // Whatever the caps hold, no sample of the isosurface takes anything of it, and the other way round.
  for (int i = 0; i < 200; ++i) {
    const test::RandomGrid grid = test::randomGrid(i);
    SCOPED_TRACE(grid.name);
    const GridView<const float> level = grid.level.view();
    const Grid<float> distance = closestDistance(level);
    const SurfaceFeet surface(level, distance.view());
    std::size_t caps = 0;
    for (int f = 0; f < kFaceCount; ++f)
      test::forEachWithin(level.size, 0, [&](glm::ivec3 at) {
        const GridFace face = faceOf(f);
        const bool border = at[face.axis] == placeOf(face, level.size);
        caps += border && level(at.x, at.y, at.z) > 0 ? 1 : 0;
      });
    std::vector<std::uint16_t> values(surface.count(), kWall);
    ASSERT_LE(caps, values.size());
    std::fill(values.end() - static_cast<std::ptrdiff_t>(caps), values.end(), kCap);
    const SurfaceField field = surface.spread(values);
    test::forEachWithin(field.paddedSize(), 0, [&](glm::ivec3 at) {
      const bool within =
          glm::all(glm::greaterThan(at, glm::ivec3(0))) && glm::all(glm::lessThan(at, field.paddedSize() - 1));
      const std::uint16_t value = field.padded(at);
      ASSERT_TRUE(value == 0 || value == (within ? kWall : kCap)) << value;
    });
  }
}

// A sheet of .8 voxel about z = 8, one sample thick, that holds another number on each side.
struct Sheet {
  Grid<float> level =
      test::sampleLevel(glm::ivec3(17), glm::dvec3(1), [](glm::dvec3 p) { return 0.4 - std::abs(p.z - 8); });
  SurfaceField field{glm::ivec3(17)};
  Sheet() {
    test::forEachWithin(glm::ivec3(17), 0, [&](glm::ivec3 at) {
      field.wall(at) = at.z == 8 ? (kWall + kCap) / 2 : at.z > 8 ? kCap : kWall;
    });
  }
};

TEST(SurfaceField, SidesOfAThinSheetDoNotMix) {
  // On both sides of a sheet thinner than a voxel a point reads its own side: the sample within, whose gradient is 0,
  // weighs kLeastAgreement, so it adds at most .02 * .6 / (.02 * .6 + .4) = .03 of the difference. Trilinear weights
  // give it .6.
  const Sheet sheet;
  for (const double x : {3.0, 5.25, 9.5}) {
    const double up = wallValueAt(sheet.field, sheet.level.view(), {x, 7.3, 8.4}, {0, 0, 1});
    const double down = wallValueAt(sheet.field, sheet.level.view(), {x, 7.3, 7.6}, {0, 0, -1});
    EXPECT_NEAR(up, kCap, 0.031 * (kCap - kWall));
    EXPECT_NEAR(down, kWall, 0.031 * (kCap - kWall));
  }
}

TEST(SurfaceField, ReadsEqualNumbersAsTheyAre) {
  // A field that holds one number everywhere gives it at every point, whatever the gradients, flat spots among them.
  const Grid<float> level = test::sampleLevel(glm::ivec3(9), glm::dvec3(1, 2, 3), [](glm::dvec3 p) {
    return p.x < 4 ? 1.0 : std::sin(3 * p.x) * std::cos(p.y) + p.z / 9 - 1;
  });
  Grid<std::uint16_t> samples(level.size());
  std::fill_n(samples.data(), samples.count(), kCap);
  const SurfaceField field = surfaceField(std::as_const(samples).view());
  for (double x = 0; x <= 8; x += 0.37)
    for (const glm::dvec3 normal : {glm::dvec3(1, 0, 0), glm::dvec3(0, -0.6, 0.8)}) {
      EXPECT_NEAR(wallValueAt(field, level.view(), {x, 8 - x, 0.5 * x}, normal), kCap, 1e-8);
      EXPECT_NEAR(surfaceValueAt(field, {x, 8 - x, 0.5 * x}), kCap, 1e-8);
    }
  for (int f = 0; f < kFaceCount; ++f) EXPECT_NEAR(capValueAt(field, faceOf(f), {2.3, 4.5, 7.9}), kCap, 1e-8);
}

TEST(SurfaceField, BySampleShowsCapsOnTheBorder) {
  // A number per sample is the cap's at samples inside on the border, the mean of two or three where faces meet, and
  // the isosurface's elsewhere.
  const Grid<float> level =
      test::sampleLevel(glm::ivec3(5, 6, 7), glm::dvec3(1), [](glm::dvec3 p) { return 3.3 - p.z; });
  SurfaceField field(level.size());
  test::forEachWithin(level.size(), 0, [&](glm::ivec3 at) {
    field.wall(at) = kWall;
    for (int f = 0; f < kFaceCount; ++f) {
      const GridFace face = faceOf(f);
      if (at[face.axis] == placeOf(face, level.size())) field.cap(face, at) = static_cast<std::uint16_t>(100 * (f + 1));
    }
  });
  const Grid<std::uint16_t> samples = bySample(field, level.view());
  test::forEachWithin(level.size(), 0, [&](glm::ivec3 at) {
    double sum = 0;
    int faces = 0;
    for (int f = 0; f < kFaceCount; ++f) {
      const GridFace face = faceOf(f);
      if (at[face.axis] != placeOf(face, level.size())) continue;
      sum += 100 * (f + 1);
      ++faces;
    }
    const bool cap = faces > 0 && at.z <= 3;
    EXPECT_NEAR(samples.view()(at.x, at.y, at.z), cap ? sum / faces : kWall, cap ? 0.5 : 0)
        << at.x << " " << at.y << " " << at.z;
  });
}

}  // namespace
}  // namespace isolume
