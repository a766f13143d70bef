// The fields file and encodeVdb.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "errors.h"
#include "io/vdb.h"
#include "io/volume.h"
#include "sweep/parallel.h"
#include "support/temp_folder.h"

namespace isolume::test {
namespace {

constexpr glm::ivec3 kSize(19, 9, 26);

/// Every kind of value that a lossy writer would change: both zeros, the backgrounds, infinities, subnormals, noise,
/// whole blocks of one value, and blocks that hold nothing but the two zeros.
Grid<float> awkward(unsigned seed) {
  Grid<float> grid(kSize, glm::dvec3(0.5, 1, 2), glm::dvec3(3, -4, 5));
  const float inf = std::numeric_limits<float>::infinity();
  const float special[] = {0.f, -0.f, 1.f, -1.f, inf, -inf, std::numeric_limits<float>::denorm_min(), 1e38f};
  unsigned state = seed;
  for (int z = 0; z < kSize.z; ++z)
    for (int y = 0; y < kSize.y; ++y)
      for (int x = 0; x < kSize.x; ++x) {
        state = state * 1664525u + 1013904223u;
        float value = static_cast<float>(state >> 8) * 1e-6f - 7;
        if (state % 5 == 0) value = special[(state >> 20) % 8];
        if (z < 8) value = x < 8 ? 1.f : y % 2 == 0 ? 0.f : -0.f;
        grid.view()(x, y, z) = value;
      }
  return grid;
}

FieldsFile makeFields() {
  FieldsFile fields;
  fields.level = awkward(1);
  fields.swept.distance = awkward(2);
  for (unsigned s = 0; s < kOctantCount; ++s) fields.swept.visibility.octants[s] = awkward(3 + s);
  // A rotation by 30 degrees about z, times the spacing: numbers that do not fit a decimal notation.
  const double c = std::cos(M_PI / 6), s = std::sin(M_PI / 6);
  fields.worldFromGrid = {{0.5 * c, 0.5 * s, 0, 0}, {-s, c, 0, 0}, {0, 0, 2, 0}, {3, -4, 5, 1}};
  fields.isovalue = 0.1;
  fields.inside = Inside::below;
  fields.summary = {.insideCount = 123456789012,
                    .replacedCount = 7,
                    .finiteMin = -1.5f,
                    .finiteMax = 0.3f,
                    .solidMin = {1, 2, 3},
                    .solidMax = {4, 5, 6}};
  fields.source = "isolume fields input.raw --iso 0.1";
  return fields;
}

void expectSameBits(const Grid<float>& a, const Grid<float>& b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(std::memcmp(a.data(), b.data(), a.count() * sizeof(float)), 0);
}

TEST(Fields, RoundTripIsBitForBit) {
  // Everything that was written comes back unchanged: bits of every field, matrix, summary, side and source.
  TempFolder folder;
  const FieldsFile fields = makeFields();
  const std::string path = folder.write("f.vdb", encodeFields(fields));
  ASSERT_TRUE(isFieldsFile(path));
  const FieldsFile back = readFields(path);
  expectSameBits(back.level, fields.level);
  expectSameBits(back.swept.distance, fields.swept.distance);
  for (std::size_t s = 0; s < kOctantCount; ++s)
    expectSameBits(back.swept.visibility.octants[s], fields.swept.visibility.octants[s]);
  EXPECT_EQ(back.worldFromGrid, fields.worldFromGrid);
  EXPECT_EQ(back.isovalue, 0.1);
  EXPECT_EQ(back.inside, Inside::below);
  EXPECT_EQ(back.summary.insideCount, fields.summary.insideCount);
  EXPECT_EQ(back.summary.replacedCount, 7u);
  EXPECT_EQ(back.summary.finiteMin, -1.5f);
  EXPECT_EQ(back.summary.finiteMax, 0.3f);
  EXPECT_EQ(back.summary.solidMin, glm::ivec3(1, 2, 3));
  EXPECT_EQ(back.summary.solidMax, glm::ivec3(4, 5, 6));
  EXPECT_EQ(back.source, fields.source);
  EXPECT_DOUBLE_EQ(back.level.view().spacing.z, 2);
}

TEST(Fields, SameBytesForAnyNumberOfThreads) {
  // The same fields give the same file, twice and with other thread counts.
  const FieldsFile fields = makeFields();
  setThreadCount(1);
  const std::string one = encodeFields(fields);
  setThreadCount(3);
  const std::string three = encodeFields(fields);
  setThreadCount(0);
  EXPECT_TRUE(one == three);
}

TEST(Fields, OtherProgramsSeeNamedFloatGrids) {
  // Read as any VDB, the file lists ten float grids over the box, and one of them reads with its transform.
  TempFolder folder;
  const FieldsFile fields = makeFields();
  const std::string path = folder.write("f.vdb", encodeFields(fields));
  std::vector<std::string> names;
  for (const VdbGridInfo& info : listVdbGrids(path)) {
    names.push_back(info.name);
    EXPECT_EQ(info.type, "float");
    EXPECT_EQ(info.indexMin, glm::ivec3(0));
    EXPECT_EQ(info.indexMax, kSize - 1);
    EXPECT_EQ(info.activeCount, voxelCount(kSize));
  }
  EXPECT_THAT(names, testing::ElementsAre("level", "distance", "visibility_nnn", "visibility_pnn", "visibility_npn",
                                          "visibility_ppn", "visibility_nnp", "visibility_pnp", "visibility_npp",
                                          "visibility_ppp"));
  const Volume level = readVolume(path, {.grid = "level", .raw = {}});
  EXPECT_EQ(level.values.size(), kSize + 2);
  EXPECT_EQ(level.values.view()(4, 5, 20), fields.level.view()(3, 4, 19));
  for (int c = 0; c < 3; ++c) EXPECT_EQ(level.worldFromGrid[c], fields.worldFromGrid[c]);
}

TEST(Fields, DamageIsNoticed) {
  // A file cut at any place, or with any one byte changed, is refused before it is decoded.
  TempFolder folder;
  const std::string good = encodeFields(makeFields());
  for (const double part : {0.001, 0.01, 0.5, 0.9, 0.99999}) {
    const auto keep = static_cast<std::size_t>(part * static_cast<double>(good.size()));
    const std::string path = folder.write("cut.vdb", good.substr(0, keep));
    EXPECT_THAT(messageOf<InputError>([&] { readFields(path); }), testing::StartsWith(path + ": "));
  }
  for (std::size_t at = 5; at < good.size(); at += good.size() / 97) {
    std::string bad = good;
    bad[at] = static_cast<char>(bad[at] ^ 16);
    const std::string path = folder.write("bad.vdb", bad);
    EXPECT_THAT(messageOf<InputError>([&] { readFields(path); }), testing::StartsWith(path + ": ")) << at;
  }
}

TEST(Fields, OtherFilesAreNot) {
  // Neither another VDB nor any other file passes for a fields file.
  TempFolder folder;
  const Grid<float> values = awkward(1);
  const std::string vdb = folder.write("v.vdb", encodeVdb(values.view(), glm::dmat4(1), "density", false));
  EXPECT_FALSE(isFieldsFile(vdb));
  EXPECT_FALSE(isFieldsFile(folder.write("a.raw", "isolume_fields")));
  EXPECT_THAT(messageOf<InputError>([&] { readFields(vdb); }), testing::HasSubstr("expected a fields file"));
}

TEST(EncodeVdb, DenseKeepsEverySample) {
  // A dense grid comes back bit for bit inside one voxel of background.
  TempFolder folder;
  const Grid<float> values = awkward(5);
  glm::dmat4 world(1);
  world[0].x = 0.5;
  world[3] = {7, 8, 9, 1};
  const Volume back = readVolume(folder.write("v.vdb", encodeVdb(values.view(), world, "density", false)));
  ASSERT_EQ(back.values.size(), kSize + 2);
  for (int z = 0; z < kSize.z; ++z)
    for (int y = 0; y < kSize.y; ++y)
      ASSERT_EQ(std::memcmp(&back.values.view()(1, y + 1, z + 1), &values.view()(0, y, z),
                            static_cast<std::size_t>(kSize.x) * sizeof(float)),
                0);
  EXPECT_EQ(back.gridName, "density");
  EXPECT_EQ(back.kind, GridKind::unknown);
  EXPECT_EQ(back.worldFromGrid[3], glm::dvec4(6.5, 7, 8, 1)) << "one voxel before the first sample";
}

TEST(EncodeVdb, LevelSetIsANarrowBand) {
  // Within three voxels of the surface the distances are kept, beyond them they are +-3 voxels; it is a level set.
  TempFolder folder;
  constexpr int kN = 41;
  constexpr double kH = 0.1;
  Grid<float> values(glm::ivec3{kN}, glm::dvec3{kH});
  const auto distance = [](int x, int y, int z) {
    return static_cast<float>(std::sqrt((x - 20) * (x - 20) + (y - 20) * (y - 20) + (z - 20) * (z - 20)) * kH - 1.5);
  };
  for (int z = 0; z < kN; ++z)
    for (int y = 0; y < kN; ++y)
      for (int x = 0; x < kN; ++x) values.view()(x, y, z) = distance(x, y, z);
  glm::dmat4 world(kH);
  world[3] = {0, 0, 0, 1};
  const Volume back = readVolume(folder.write("s.vdb", encodeVdb(values.view(), world, "surface", true)));
  EXPECT_EQ(back.kind, GridKind::levelSet);
  const glm::dvec3 first = (glm::dvec3(back.worldFromGrid[3]) / kH);
  const auto band = static_cast<float>(3 * kH);
  for (int z = 0; z < back.values.size().z; ++z)
    for (int y = 0; y < back.values.size().y; ++y)
      for (int x = 0; x < back.values.size().x; ++x) {
        const glm::dvec3 p = glm::round(first) + glm::dvec3(x, y, z);
        const float d = distance(static_cast<int>(p.x), static_cast<int>(p.y), static_cast<int>(p.z));
        ASSERT_EQ(back.values.view()(x, y, z), std::clamp(d, -band, band));
      }
}

}  // namespace
}  // namespace isolume::test
