// Grids made with OpenVDB and read back.
#include "io/vdb.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <openvdb/io/Stream.h>
#include <openvdb/openvdb.h>

#include <cmath>
#include <sstream>

#include "errors.h"
#include "io/volume.h"
#include "support/temp_folder.h"

namespace isolume::test {
namespace {

using openvdb::Coord;
using testing::AllOf;
using testing::HasSubstr;

class Vdb : public testing::Test {
 protected:
  void SetUp() override { openvdb::initialize(); }

  std::string write(const openvdb::GridPtrVec& grids) const {
    openvdb::io::File file(folder_.path("v.vdb"));
    file.write(grids);
    file.close();
    return folder_.path("v.vdb");
  }
  template <class GridT>
  typename GridT::Ptr gridOf(const std::string& name, typename GridT::ValueType background,
                             typename GridT::ValueType value) const {
    auto grid = GridT::create(background);
    grid->setName(name);
    grid->tree().setValueOn(Coord(10, -20, 30), value);
    grid->tree().setValueOn(Coord(12, -20, 31), value);
    return grid;
  }
  Volume read(const std::string& path, const std::string& grid = "") const {
    return readVolume(path, {.grid = grid, .raw = {}});
  }

  TempFolder folder_;
};

TEST_F(Vdb, BoxPaddingAndBackground) {
  // The dense box is the active one plus a voxel on each side; all else in it holds the background.
  const Volume v = read(write({gridOf<openvdb::FloatGrid>("density", 0.25f, 2)}));
  ASSERT_EQ(v.values.size(), glm::ivec3(5, 3, 4));
  for (int z = 0; z < 4; ++z)
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 5; ++x) {
        const bool on = y == 1 && ((x == 1 && z == 1) || (x == 3 && z == 2));
        EXPECT_EQ(v.values.view()(x, y, z), on ? 2.f : 0.25f);
      }
  EXPECT_EQ(v.worldFromGrid[3], glm::dvec4(9, -21, 29, 1));
  EXPECT_EQ(v.sampleType, "float");
  EXPECT_EQ(v.gridName, "density");
  EXPECT_EQ(v.format, "VDB");
}

TEST_F(Vdb, EveryScalarType) {
  // float, double, half-stored, int32, int64 and bool grids are read, each under its name.
  auto half = gridOf<openvdb::FloatGrid>("half", 0, 0.5f);
  half->setSaveFloatAsHalf(true);
  const std::string path =
      write({gridOf<openvdb::FloatGrid>("float", 0, 0.1f), gridOf<openvdb::DoubleGrid>("double", 0, 0.1), half,
             gridOf<openvdb::Int32Grid>("int32", -3, 7), gridOf<openvdb::Int64Grid>("int64", -3, 7),
             gridOf<openvdb::BoolGrid>("bool", false, true)});
  const std::vector<std::pair<std::string, float>> expected{{"float", 0.1f}, {"double", 0.1f}, {"half", 0.5f},
                                                            {"int32", 7.f},  {"int64", 7.f},   {"bool", 1.f}};
  for (const auto& [name, value] : expected) {
    const Volume v = read(path, name);
    EXPECT_EQ(v.sampleType, name);
    EXPECT_EQ(v.values.view()(1, 1, 1), value) << name;
    EXPECT_EQ(v.values.view()(3, 1, 2), value) << name;
    EXPECT_EQ(v.values.view()(2, 1, 1), name.starts_with("int") ? -3.f : 0.f) << name;
  }
}

TEST_F(Vdb, KindOfGrid) {
  // Level sets and fog volumes are told apart by what the file says about them.
  auto level = gridOf<openvdb::FloatGrid>("surface", 0.3f, -0.1f);
  level->setGridClass(openvdb::GRID_LEVEL_SET);
  auto fog = gridOf<openvdb::FloatGrid>("density", 0, 1);
  fog->setGridClass(openvdb::GRID_FOG_VOLUME);
  const std::string path = write({level, fog});
  EXPECT_EQ(read(path, "surface").kind, GridKind::levelSet);
  EXPECT_EQ(read(path, "density").kind, GridKind::fog);
}

TEST_F(Vdb, TilesAndInactiveValues) {
  // Active tiles, inactive tiles and inactive voxels give the values that the tree holds there, not the background.
  auto grid = openvdb::FloatGrid::create(5);
  grid->tree().addTile(1, Coord(0), 1, true);         // 8^3 active
  grid->tree().addTile(1, Coord(8, 0, 0), 2, false);  // 8^3 inactive, inside the active box
  grid->tree().setValueOn(Coord(17, 0, 0), 3);
  grid->tree().setValueOff(Coord(18, 0, 0), 4);  // in the padding
  const Volume v = read(write({grid}));
  ASSERT_EQ(v.values.size(), glm::ivec3(20, 10, 10));
  EXPECT_EQ(v.values.view()(0, 1, 1), 5);
  EXPECT_EQ(v.values.view()(1, 1, 1), 1);
  EXPECT_EQ(v.values.view()(8, 8, 8), 1);
  EXPECT_EQ(v.values.view()(9, 1, 1), 2);
  EXPECT_EQ(v.values.view()(18, 1, 1), 3);
  EXPECT_EQ(v.values.view()(19, 1, 1), 4);
}

TEST_F(Vdb, WideIntegersAndDoublesKeepTheirVariation) {
  // Values that float32 would merge come back through the offset, exactly for integers.
  auto ints = openvdb::Int64Grid::create(9'000'000'000'000'000);
  ints->tree().setValueOn(Coord(0), 9'000'000'000'000'001);
  ints->setName("i");
  auto doubles = openvdb::DoubleGrid::create(1e6);
  doubles->tree().setValueOn(Coord(0), 1e6 + 1e-6);
  doubles->setName("d");
  const std::string path = write({ints, doubles});
  const Volume i = read(path, "i"), d = read(path, "d");
  EXPECT_EQ(i.values.view()(1, 1, 1) - i.values.view()(0, 0, 0), 1);
  // 1e6 + 1e-6 itself is stored in steps of 1.2e-10.
  EXPECT_NEAR(d.values.view()(1, 1, 1) - d.values.view()(0, 0, 0), 1e-6, 1.2e-10);
  EXPECT_NEAR(d.valueOffset, 1e6, 1);
}

TEST_F(Vdb, TransformsThatAreKept) {
  // Scale, anisotropic scale, rotation, translation and reflection arrive as the matrix that OpenVDB itself applies.
  using openvdb::math::Mat4d;
  std::vector<openvdb::math::Transform::Ptr> transforms{openvdb::math::Transform::createLinearTransform(0.1)};
  Mat4d m = Mat4d::identity();
  m.postScale(openvdb::Vec3d(0.5, 1, 2));
  m.postRotate(openvdb::math::X_AXIS, 0.3);
  m.postRotate(openvdb::math::Z_AXIS, -1.1);
  m.postTranslate(openvdb::Vec3d(100, 200, 300));
  transforms.push_back(openvdb::math::Transform::createLinearTransform(m));
  Mat4d mirror = Mat4d::identity();
  mirror(0, 0) = -0.25;
  transforms.push_back(openvdb::math::Transform::createLinearTransform(mirror));
  // 0.1 mm in metres; OpenVDB takes a voxel below 3e-15 of volume for singular.
  transforms.push_back(openvdb::math::Transform::Ptr(new openvdb::math::Transform(
      openvdb::math::MapBase::Ptr(new openvdb::math::UniformScaleTranslateMap(1e-4, openvdb::Vec3d(1e-3, 0, 0))))));
  for (const auto& transform : transforms) {
    auto grid = gridOf<openvdb::FloatGrid>("density", 0, 1);
    grid->setTransform(transform);
    const Volume v = read(write({grid}));
    const double unit = v.values.view().spacing.x;
    for (int z = 0; z < 4; ++z)
      for (int x = 0; x < 5; ++x) {
        const openvdb::Vec3d want = transform->indexToWorld(Coord(9 + x, -20, 29 + z));
        const glm::dvec4 got = v.worldFromGrid * glm::dvec4(x, 1, z, 1);
        // Coordinates of a few hundred voxels, each known to 1e-16 of itself.
        for (int a = 0; a < 3; ++a) EXPECT_NEAR(got[a], want[a], 1e-12 * std::max(unit, std::abs(want[a])));
      }
  }
}

TEST_F(Vdb, TransformsThatAreRefused) {
  // Shear and frustum are errors, not approximations.
  openvdb::math::Mat4d shear = openvdb::math::Mat4d::identity();
  shear(1, 0) = 0.2;
  auto grid = gridOf<openvdb::FloatGrid>("density", 0, 1);
  grid->setTransform(openvdb::math::Transform::createLinearTransform(shear));
  EXPECT_THAT(messageOf<InputError>([&] { read(write({grid})); }), HasSubstr("shear"));
  grid->setTransform(
      openvdb::math::Transform::createFrustumTransform(openvdb::BBoxd(openvdb::Vec3d(0), openvdb::Vec3d(100)), 0.5, 1));
  EXPECT_THAT(messageOf<InputError>([&] { read(write({grid})); }), HasSubstr("frustum"));
  EXPECT_EQ(listVdbGrids(folder_.path("v.vdb")).size(), 1u) << "a grid that cannot be drawn can be listed";
}

TEST_F(Vdb, ChoosingAGrid) {
  // The only scalar grid is taken without a name; NAME, NAME[i] and their failures are told apart.
  auto vectors = openvdb::Vec3SGrid::create();
  vectors->setName("velocity");
  vectors->tree().setValueOn(Coord(0), openvdb::Vec3s(1));
  EXPECT_EQ(read(write({vectors, gridOf<openvdb::FloatGrid>("density", 0, 1)})).gridName, "density");
  EXPECT_THAT(messageOf<InputError>([&] { read(folder_.path("v.vdb"), "velocity"); }),
              AllOf(HasSubstr("expected a scalar grid, found vec3s"), HasSubstr("density (float)")));
  EXPECT_THAT(messageOf<InputError>([&] { read(folder_.path("v.vdb"), "heat"); }),
              AllOf(HasSubstr("'heat'"), HasSubstr("density (float)")));
  EXPECT_THAT(messageOf<InputError>([&] { read(write({vectors})); }),
              AllOf(HasSubstr("expected a scalar grid"), HasSubstr("velocity (vec3s)")));
  EXPECT_THAT(messageOf<InputError>([&] { read(write({})); }), HasSubstr("no grid"));

  const std::string many =
      write({gridOf<openvdb::FloatGrid>("density", 0, 1), gridOf<openvdb::FloatGrid>("density", 0, 2),
             gridOf<openvdb::FloatGrid>("heat", 0, 3)});
  EXPECT_THAT(messageOf<InputError>([&] { read(many); }),
              AllOf(HasSubstr("--grid"), HasSubstr("density[0] (float), density[1] (float), heat (float)")));
  EXPECT_THAT(messageOf<InputError>([&] { read(many, "density"); }), HasSubstr("expected one grid 'density'"));
  EXPECT_THAT(messageOf<InputError>([&] { read(many, "density[2]"); }), HasSubstr("'density[2]'"));
  EXPECT_EQ(read(many, "density[1]").values.view()(1, 1, 1), 2);
  EXPECT_EQ(read(many, "density[0]").values.view()(1, 1, 1), 1);
  EXPECT_EQ(read(many, "heat").values.view()(1, 1, 1), 3);
}

TEST_F(Vdb, GridsWithoutNamesAndShared) {
  // A nameless grid is listed as [0], and a grid that shares its tree with another one has the same samples.
  auto nameless = gridOf<openvdb::FloatGrid>("", 0, 4);
  auto shared = openvdb::FloatGrid::create(nameless->treePtr());
  shared->setName("copy");
  shared->setTransform(openvdb::math::Transform::createLinearTransform(3));
  const std::string path = write({nameless, shared});
  EXPECT_EQ(listVdbGrids(path)[0].name, "[0]");
  EXPECT_EQ(read(path, "[0]").values.view()(1, 1, 1), 4);
  EXPECT_EQ(read(path, "copy").values.view()(1, 1, 1), 4);
  EXPECT_EQ(read(path, "copy").values.view().spacing, glm::dvec3(3));
}

TEST_F(Vdb, ListTellsWhatIsThere) {
  // Name, type, kind, box and count of every grid, drawn or not.
  auto level = gridOf<openvdb::FloatGrid>("surface", 0.3f, -0.1f);
  level->setGridClass(openvdb::GRID_LEVEL_SET);
  level->setSaveFloatAsHalf(true);
  auto vectors = openvdb::Vec3SGrid::create();
  vectors->setName("velocity");
  const auto infos = listVdbGrids(write({level, vectors}));
  ASSERT_EQ(infos.size(), 2u);
  EXPECT_EQ(infos[0].name, "surface");
  EXPECT_EQ(infos[0].type, "half");
  EXPECT_EQ(infos[0].kind, "level set");
  EXPECT_TRUE(infos[0].scalar);
  EXPECT_EQ(infos[0].activeCount, 2u);
  EXPECT_EQ(infos[0].indexMin, glm::ivec3(10, -20, 30));
  EXPECT_EQ(infos[0].indexMax, glm::ivec3(12, -20, 31));
  EXPECT_FALSE(infos[1].scalar);
  EXPECT_EQ(infos[1].activeCount, 0u);
}

TEST_F(Vdb, NothingToDraw) {
  // An empty grid, and a box that no memory holds, are errors with their sizes.
  auto empty = openvdb::FloatGrid::create(1);
  empty->setName("nothing");
  EXPECT_THAT(messageOf<InputError>([&] { read(write({empty})); }),
              AllOf(HasSubstr("nothing"), HasSubstr("found none")));
  auto wide = openvdb::FloatGrid::create(0);
  wide->tree().setValueOn(Coord(0), 1);
  wide->tree().setValueOn(Coord(100'000), 1);
  EXPECT_THAT(messageOf<InputError>([&] { read(write({wide})); }),
              AllOf(HasSubstr("100003x100003x100003"), HasSubstr("3.6 PiB"), HasSubstr("available")));
  auto edge = openvdb::FloatGrid::create(0);
  edge->tree().setValueOn(Coord(std::numeric_limits<int>::max(), 0, 0), 1);
  EXPECT_THAT(messageOf<InputError>([&] { read(write({edge})); }), HasSubstr("32 bits"));
}

TEST_F(Vdb, FilesWithoutOffsets) {
  // A file that was written to a stream, and so cannot be skipped through, reads the same.
  std::ostringstream out(std::ios::binary);
  openvdb::io::Stream(out).write(
      openvdb::GridCPtrVec{gridOf<openvdb::FloatGrid>("a", 0, 1), gridOf<openvdb::Int32Grid>("b", 0, 2)});
  const std::string path = folder_.write("s.vdb", out.str());
  EXPECT_EQ(listVdbGrids(path).size(), 2u);
  EXPECT_EQ(read(path, "a").values.view()(1, 1, 1), 1);
  EXPECT_EQ(read(path, "b").values.view()(3, 1, 2), 2);
}

TEST_F(Vdb, CutAnywhereIsAnError) {
  // However short a file is cut, with offsets or without, the result is one error and no crash.
  auto grid = gridOf<openvdb::FloatGrid>("density", 0, 1);
  grid->fill(openvdb::CoordBBox(Coord(0), Coord(11)), 2);
  std::ostringstream out(std::ios::binary);
  openvdb::io::Stream(out).write(openvdb::GridCPtrVec{grid});
  for (const std::string& whole : {fileBytes(write({grid})), out.str()})
    for (std::size_t keep = 1; keep < whole.size(); keep += keep < 600 ? 1 : 97) {
      const std::string path = folder_.write("cut.vdb", whole.substr(0, keep));
      EXPECT_THAT(messageOf<InputError>([&] { read(path); }), HasSubstr("cut.vdb: ")) << keep << " of " << whole.size();
    }
  // Where the file says how long it is, the message does too.
  const std::string whole = fileBytes(write({grid}));
  const std::string path = folder_.write("cut.vdb", whole.substr(0, whole.size() - 1));
  EXPECT_THAT(messageOf<InputError>([&] { read(path); }),
              HasSubstr("expected at least " + std::to_string(whole.size()) + " bytes (grid 'density'), found " +
                        std::to_string(whole.size() - 1)));
}

}  // namespace
}  // namespace isolume::test
