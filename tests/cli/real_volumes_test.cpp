// Volumes that other tools wrote, each at an isovalue that shows what is known to be in it.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>

#include "cli/picture.h"
#include "cli/program.h"
#include "support/shared_data.h"

namespace isolume::test {
namespace {

struct RealVolume {
  std::string name, file, isovalue;
  std::vector<std::string> more;
  bool needsItk = false;
};

std::ostream& operator<<(std::ostream& out, const RealVolume& volume) { return out << volume.name; }

std::vector<RealVolume> realVolumes() {
  return {
      {"Smoke", "smoke.vdb", "0.5", {}},
      {"SphereLevelSet", "sphere_ls.vdb", "0", {}},
      {"AortaLevelSet", "aorta_ls.vdb", "0", {}},
      {"CraniumRaw", "cranium_256x256x108_int16.raw", "300", {"--spacing", "0.957,0.957,1.5"}},
      {"CraniumMhd", "cranium.mhd", "300", {}},
      {"CraniumNhdr", "cranium.nhdr", "-300", {}},
      {"BenzeneRaw", "benzene_homo_55x55x40_float32.raw", "0.03", {}},
      {"BenzeneMhdBelow", "benzene_homo.mhd", "-0.03", {"--inside", "below"}},
      {"StatisticsWithNan", "narps4735_nan_97x115x81_float32.raw", "2.3", {}},
      {"Mni152", "mni152_2009.nii.gz", "600", {}, true},
      {"Ch2better", "ch2better.nii.gz", "60", {}, true},
      {"BetaGal", "betaGal.mrc", "0.06", {}, true},
      {"Flair", "flair.nrrd", "60", {}, true},
      {"AortaCta", "aorta_cta.mha", "800", {}, true},
  };
}

class RealVolumes : public ProgramTest, public ::testing::WithParamInterface<RealVolume> {};

TEST_P(RealVolumes, Render) {
  // The file renders at its isovalue: the solid is in the picture, away from its edges, with finite, shaded colours.
  const RealVolume& volume = GetParam();
#ifndef ISOLUME_HAVE_ITK
  if (volume.needsItk) GTEST_SKIP() << "this build has no ITK to read " << volume.file;
#endif
  ISOLUME_NEED_SHARED(input, volume.file);
  std::vector<std::string> command{"render",   input, "--isovalue", volume.isovalue, "--size", "64x64",
                                   "--layers", "all", "-o",         "out.exr"};
  command.insert(command.end(), volume.more.begin(), volume.more.end());
  ASSERT_EQ(runWell(command).exitCode, 0);
  const Image image = readImage(path("out.exr"));
  const std::vector<float>&depth = channel(image, "Z"), &openness = channel(image, "ambient.Y");
  std::size_t hits = 0;
  float darkest = 1, brightest = 0;
  for (std::size_t i = 0; i < depth.size(); ++i) {
    if (!std::isfinite(depth[i])) continue;
    ++hits;
    ASSERT_TRUE(openness[i] >= 0 && openness[i] <= 1) << openness[i];
    darkest = std::min(darkest, openness[i]);
    brightest = std::max(brightest, openness[i]);
  }
  EXPECT_GT(hits, depth.size() / 50);  // two per cent of the picture: the thinnest of these solids cover five
  // A ball is open all over; everything else shades itself.
  if (std::string(GetParam().name) == "SphereLevelSet") {
    EXPECT_GT(darkest, 0.99);
  } else {
    EXPECT_GT(brightest, darkest);
  }
  for (const char* name : {"R", "G", "B", "A"})
    for (const float value : channel(image, name)) ASSERT_TRUE(std::isfinite(value));
}

INSTANTIATE_TEST_SUITE_P(Shared, RealVolumes, ::testing::ValuesIn(realVolumes()),
                         [](const auto& each) { return each.param.name; });

TEST_F(ProgramTest, HeaderAndRawOfOneVolumeDrawTheSame) {
  // The .mhd, the .nhdr and the raw file with the spacing said by hand describe one volume: same bits in every layer.
  ISOLUME_NEED_SHARED(raw, "cranium_256x256x108_int16.raw");
  ISOLUME_NEED_SHARED(mhd, "cranium.mhd");
  ISOLUME_NEED_SHARED(nhdr, "cranium.nhdr");
  const auto draw = [&](const std::string& input, const std::string& output, std::vector<std::string> more) {
    more.insert(more.begin(),
                {"render", input, "--isovalue", "300", "--size", "48x48", "--layers", "all", "-o", output});
    runWell(more);
    return readImage(path(output));
  };
  const Image fromMhd = draw(mhd, "mhd.exr", {});
  EXPECT_TRUE(sameBits(fromMhd, draw(nhdr, "nhdr.exr", {})));
  EXPECT_TRUE(sameBits(fromMhd, draw(raw, "raw.exr", {"--spacing", "0.9570312,0.9570312,1.5"})));
}

}  // namespace
}  // namespace isolume::test
