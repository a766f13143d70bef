// Files that real tools wrote: dims, spacing, type and range of each as its table says.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "errors.h"
#include "io/statistics.h"
#include "io/vdb.h"
#include "io/volume.h"
#include "support/shared_data.h"
#include "support/temp_folder.h"

namespace isolume::test {
namespace {

struct Expected {
  glm::ivec3 size;
  glm::dvec3 spacing;
  std::string format, type;
  double min, max;
  double tolerance;  ///< of the range: half of the last digit that the table gives
};

Volume expectVolume(const std::string& path, const Expected& expected) {
  Volume volume = readVolume(path);
  EXPECT_EQ(volume.values.size(), expected.size);
  // Headers store spacings as float32 or with 6 or 7 digits.
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(volume.values.view().spacing[i], expected.spacing[i], 1e-6 * expected.spacing[i]);
  EXPECT_EQ(volume.format, expected.format);
  EXPECT_EQ(volume.sampleType, expected.type);
  const VolumeStatistics statistics = computeStatistics(volume);
  EXPECT_NEAR(statistics.min, expected.min, expected.tolerance);
  EXPECT_NEAR(statistics.max, expected.max, expected.tolerance);
  return volume;
}

TEST(SharedData, CraniumThreeWays) {
  // The head CT is the same sample by sample through its name, its .mhd and its .nhdr.
  ISOLUME_NEED_SHARED(raw, "cranium_256x256x108_int16.raw");
  const glm::ivec3 size(256, 256, 108);
  const glm::dvec3 spacing(0.9570312, 0.9570312, 1.5);
  const Volume a = expectVolume(raw, {size, glm::dvec3(1), "raw", "int16", -1024, 2986, 0});
  const Volume b = expectVolume(sharedData("cranium.mhd"), {size, spacing, "MetaImage", "int16", -1024, 2986, 0});
  const Volume c = expectVolume(sharedData("cranium.nhdr"), {size, spacing, "NRRD", "int16", -1024, 2986, 0});
  EXPECT_EQ(std::memcmp(a.values.data(), b.values.data(), a.values.count() * sizeof(float)), 0);
  EXPECT_EQ(std::memcmp(a.values.data(), c.values.data(), a.values.count() * sizeof(float)), 0);
  EXPECT_EQ(b.worldFromGrid, c.worldFromGrid);
}

TEST(SharedData, Benzene) {
  // The orbital keeps its origin, in either way of naming it.
  ISOLUME_NEED_SHARED(path, "benzene_homo.mhd");
  const glm::ivec3 size(55, 55, 40);
  const Volume a = expectVolume(path, {size, glm::dvec3(0.333333), "MetaImage", "float32", -0.2125, 0.2125, 5e-5});
  EXPECT_EQ(a.worldFromGrid[3], glm::dvec4(-9.02198, -9.06944, -6.51278, 1));
  expectVolume(sharedData("benzene_homo_55x55x40_float32.raw"),
               {size, glm::dvec3(1), "raw", "float32", -0.2125, 0.2125, 5e-5});
}

TEST(SharedData, NarpsKeepsItsNan) {
  // The t-map has 684,992 NaN, which are counted and kept.
  ISOLUME_NEED_SHARED(path, "narps4735_nan_97x115x81_float32.raw");
  const Volume volume = expectVolume(path, {{97, 115, 81}, glm::dvec3(1), "raw", "float32", -6.895, 5.118, 5e-4});
  EXPECT_EQ(computeStatistics(volume).nanCount, 684'992u);
}

TEST(SharedData, Smoke) {
  // The fog volume has its box, voxel size and place; outside its active voxels it is 0.
  ISOLUME_NEED_SHARED(path, "smoke.vdb");
  const Volume volume = expectVolume(path, {{113, 224, 114}, glm::dvec3(10.0 / 21), "VDB", "half", 0, 5.71, 5e-3});
  EXPECT_EQ(volume.kind, GridKind::fog);
  EXPECT_EQ(volume.gridName, "density");
  const std::vector<VdbGridInfo> grids = listVdbGrids(path);
  ASSERT_EQ(grids.size(), 1u);
  EXPECT_EQ(grids[0].activeCount, 1'049'275u);
  EXPECT_EQ(grids[0].indexMin, glm::ivec3(1, 2, 1));
  // The table rounds the spacing, 10/21, to 0.476. Index (0, 1, 0) is the first padded sample.
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(volume.worldFromGrid[3][i], glm::dvec3(-34, -13.1 + 0.476, -26.4)[i], 0.05) << "table gives 3 digits";
}

TEST(SharedData, SphereCrossesZeroAtRadius3) {
  // Along +x from the centre the distance changes sign at world x = 3, to the precision of half floats.
  ISOLUME_NEED_SHARED(path, "sphere_ls.vdb");
  const Volume volume = readVolume(path);
  EXPECT_EQ(volume.kind, GridKind::levelSet);
  EXPECT_EQ(volume.values.size(), glm::ivec3(127));
  EXPECT_NEAR(volume.values.view().spacing.x, 0.05, 1e-9);
  const auto values = volume.values.view();
  int crossings = 0;
  for (int x = 63; x < 126; ++x) {
    const double a = values(x, 63, 63), b = values(x + 1, 63, 63);
    if ((a < 0) == (b < 0)) continue;
    ++crossings;
    const glm::dvec4 p = volume.worldFromGrid * glm::dvec4(x + a / (a - b), 63, 63, 1);
    // Half floats near 0.05 have steps of 3e-5.
    EXPECT_NEAR(p.x, 3.0, 1e-4);
    EXPECT_NEAR(p.y, 0, 1e-9);
  }
  EXPECT_EQ(crossings, 1);
}

TEST(SharedData, AortaLevelSet) {
  // A grid far from the index origin keeps its place in the world.
  ISOLUME_NEED_SHARED(path, "aorta_ls.vdb");
  const Volume volume = readVolume(path);
  EXPECT_EQ(volume.values.size(), glm::ivec3(145, 344, 100));
  EXPECT_EQ(volume.kind, GridKind::levelSet);
  EXPECT_EQ(volume.sampleType, "float");
  EXPECT_EQ(volume.worldFromGrid[3], glm::dvec4(0.25 * 819, 0.25 * 387, 0.25 * 46, 1));
}

TEST(SharedData, VtiIsRefused) {
  // A format that nobody here reads is named, with what is supported.
  ISOLUME_NEED_SHARED(path, "headsq.vti");
  EXPECT_THAT(messageOf<InputError>([&] { readVolume(path); }),
              testing::AllOf(testing::HasSubstr(".vti"), testing::HasSubstr("VDB, raw")));
}

TEST(SharedData, CutShortIsAnError) {
  // Each self-describing file, cut to a part, is refused with one line: nothing is read half.
  for (const char* name : {"smoke.vdb", "sphere_ls.vdb", "aorta_ls.vdb", "mni152_2009.nii.gz", "ch2better.nii.gz",
                           "betaGal.mrc", "flair.nrrd", "aorta_cta.mha"}) {
    ISOLUME_NEED_SHARED(path, name);
    const std::string whole = fileBytes(path);
    TempFolder folder;
    for (const double part : {0.001, 0.3, 0.9, 0.9999}) {
      const auto keep = static_cast<std::size_t>(part * static_cast<double>(whole.size()));
      const std::string cut = folder.write(name, whole.substr(0, keep));
      EXPECT_THAT(messageOf<InputError>([&] { readVolume(cut); }), testing::StartsWith(cut + ": ")) << name << part;
    }
  }
}

#ifdef ISOLUME_HAVE_ITK
TEST(SharedData, ThroughItk) {
  // NIfTI, MRC, NRRD and MetaImage arrive with the size, spacing, type and range of the table.
  ISOLUME_NEED_SHARED(mni, "mni152_2009.nii.gz");
  expectVolume(mni, {{193, 229, 193}, glm::dvec3(1), "NIfTI", "int16", 0, 1570, 0});
  expectVolume(sharedData("ch2better.nii.gz"), {{301, 370, 316}, glm::dvec3(0.5), "NIfTI", "uint8", 0, 130, 0});
  expectVolume(sharedData("betaGal.mrc"), {glm::ivec3(100), glm::dvec3(3.54), "MRC", "float32", -0.053, 0.197, 5e-4});
  const Volume flair =
      expectVolume(sharedData("flair.nrrd"), {{124, 160, 140}, glm::dvec3(1), "NRRD", "uint8", 0, 255, 0});
  EXPECT_NEAR(flair.worldFromGrid[0].x, -0.99359200921208746, 1e-12) << "oblique axes are kept";
  EXPECT_NEAR(flair.worldFromGrid[2].y, -0.30536684015686016, 1e-12);
  EXPECT_NEAR(flair.worldFromGrid[3].y, 110.4311447143555, 1e-12);
  EXPECT_EQ(flair.world, "LPS millimetres");
  const Volume aorta =
      expectVolume(sharedData("aorta_cta.mha"),
                   {{157, 393, 34}, {0.878906, 0.878906, 1.50009}, "MetaImage", "float32", 0, 2570, 0.5});
  EXPECT_EQ(aorta.worldFromGrid[0], glm::dvec4(-0.878906, 0, 0, 0)) << "TransformMatrix -1 0 0 0 -1 0 0 0 1";
  EXPECT_EQ(aorta.worldFromGrid[1], glm::dvec4(0, -0.878906, 0, 0));
  EXPECT_EQ(aorta.worldFromGrid[3], glm::dvec4(-156.445, -24.6094, 0, 1));
}
#endif

}  // namespace
}  // namespace isolume::test
