// Which pixels are compared, and which files cannot be.
#include "src/compare/layer_pair.h"

#include <gmock/gmock.h>

#include "compare/pictures.h"
#include "src/errors.h"
#include "support/temp_folder.h"

namespace isolume::test {
namespace {

using ::testing::HasSubstr;

TEST(LayerPair, OnlyPixelsThatBothHitAreCompared) {
  // Values where either misses do not count, whatever they are; the share of misses is of what either hits.
  Image got = picture({5, 1}, {0.5f, 100, 0.5f, -100, 7}), want = picture({5, 1}, {0.25f, 0, 0.5f, 0, 3});
  channelOf(got, "Z") = {1, 1, 1, kInf, kInf};
  channelOf(want, "Z") = {1, kInf, 1, 1, kInf};
  const Comparison c = compare(got, want);
  EXPECT_EQ(c.pixels.all, 5u);
  EXPECT_EQ(c.pixels.both, 2u);
  EXPECT_EQ(c.pixels.gotOnly, 1u);
  EXPECT_EQ(c.pixels.wantOnly, 1u);
  EXPECT_EQ(c.pixels.miss(), 0.5);
  EXPECT_EQ(c.measures[0].measures.count, 2u);
  EXPECT_EQ(c.measures[0].measures.bias, 0.125);
}

TEST(LayerPair, PicturesWithoutAnyHit) {
  // Nothing hit: no measure, no similarity, no miss, no fault; hit by one alone: all is missed.
  Image miss = picture({3, 2}, std::vector<float>(6, 1));
  channelOf(miss, "Z").assign(6, kInf);
  const Comparison none = compare(miss, miss);
  EXPECT_EQ(none.measures[0].measures.count, 0u);
  EXPECT_FALSE(none.ssim);
  EXPECT_EQ(none.pixels.miss(), 0);
  EXPECT_TRUE(comparisonJson(none)["measures"][0]["rmse"].is_null());
  EXPECT_TRUE(comparisonJson(none)["ssim"].is_null());
  EXPECT_THAT(comparisonText(none), HasSubstr("nothing to compare"));
  EXPECT_EQ(compare(miss, picture({3, 2}, std::vector<float>(6, 1))).pixels.miss(), 1);
}

TEST(LayerPair, HitsAreToldByDepthThenPositionThenAlpha) {
  // Each file by itself: Z if it has it, else position, else alpha.
  Image depth = picture({2, 1}, {0, 0});
  channelOf(depth, "Z") = {1, kInf};
  addVectors(depth, "position", {{kNan, kNan, kNan}, {0, 0, 0}});  // says the opposite, and is not asked
  Image position = picture({2, 1}, {0, 0});
  position.channels.pop_back();
  addVectors(position, "position", {{kNan, 0, 0}, {kNan, kNan, kNan}});
  Image alpha = picture({2, 1}, {0, 0});
  alpha.channels.back() = {"A", {0.5f, 0.25f}};
  for (const auto& [image, from] : {std::pair{&depth, "Z"}, {&position, "position"}, {&alpha, "A"}}) {
    const LayerPair pair = pairOf(*image, depth);
    EXPECT_EQ(pair.gotHitsFrom, from);
    EXPECT_EQ(pair.wantHitsFrom, "Z");
    EXPECT_EQ(pair.pixels, (std::vector<std::uint8_t>{kCompared, 0})) << from;
  }
}

TEST(LayerPair, UnknownHitsAreRefused) {
  // Without Z and position, an alpha of 1 everywhere (an opaque background) or none at all tells nothing.
  const Image good = picture({2, 1}, {0, 0});
  Image opaque = good, bare = good;
  opaque.channels.back() = {"A", {1, 1}};
  bare.channels.pop_back();
  EXPECT_THAT(messageOf<InputError>([&] { pairOf(opaque, good); }), HasSubstr("got.exr: expected channels Z or"));
  EXPECT_THAT(messageOf<InputError>([&] { pairOf(good, bare); }), HasSubstr("want.exr: expected channels Z"));
}

TEST(LayerPair, NanOnAHitIsAFaultOfEitherFile) {
  // NaN and infinities are counted where their own file hits, with the first place; elsewhere they mean nothing.
  const Image good = picture({4, 2}, std::vector<float>(8, 0.5f));
  Image bad = good;
  channelOf(bad, "ambient.Y") = {0.5f, 0.5f, 0.5f, kNan, 0.5f, kInf, -kInf, kNan};
  channelOf(bad, "Z")[3] = kInf;
  for (const bool inGot : {true, false}) {
    const LayerPair pair = inGot ? pairOf(bad, good) : pairOf(good, bad);
    EXPECT_EQ(pair.faults.nan, 1u);
    EXPECT_EQ(pair.faults.infinite, 2u);
    EXPECT_EQ(pair.faults.firstFile, inGot ? "got.exr" : "want.exr");
    EXPECT_EQ(pair.faults.firstPixel, glm::ivec2(1, 1));
    EXPECT_EQ(compareLayer(pair).pixels.compared, 4u);
    EXPECT_EQ(compareLayer(pair).measures[0].measures.max, 0);
  }
  EXPECT_EQ(pairOf(bad, bad).faults.infinite, 4u);  // equal infinities are no agreement
}

TEST(LayerPair, NanDepthIsAHitAndAFault) {
  // A NaN in Z is no way to say "miss": comparing Z finds it.
  Image bad = picture({2, 1}, {0, 0});
  channelOf(bad, "Z")[1] = kNan;
  EXPECT_EQ(pairOf(bad, picture({2, 1}, {0, 0}), "Z").faults.nan, 1u);
}

TEST(LayerPair, SizesMustAgree) {
  // Pictures of different sizes are refused with both sizes, also if they have as many pixels.
  const std::string message = messageOf<InputError>([] { pairOf(noisePicture({4, 6}, 1), noisePicture({6, 4}, 1)); });
  EXPECT_EQ(message, "got.exr: expected 6 x 4 pixels as in want.exr, found 4 x 6");
}

TEST(LayerPair, MissingLayersAreNamed) {
  // A layer that one file lacks, or has other channels of, is refused with what is there.
  const Image has = picture({1, 1}, {0}), lacks = picture({1, 1}, {0}, "openness.Y");
  EXPECT_EQ(messageOf<InputError>([&] { pairOf(lacks, has); }),
            "got.exr: expected a layer or channel 'ambient', found the channels openness.Y, Z");
  EXPECT_THAT(messageOf<InputError>([&] { pairOf(has, lacks); }), HasSubstr("want.exr: expected a layer or channel"));
  Image three = has;
  addVectors(three, "ambient", {{0, 0, 0}});
  three.channels.erase(three.channels.begin());
  EXPECT_THAT(messageOf<InputError>([&] { pairOf(three, has); }), HasSubstr("found ambient.X, ambient.Y, ambient.Z"));
}

TEST(LayerPair, NamesOfLayersAndChannels) {
  // A layer is its own channels alone: not those of a name that it begins, nor those of a layer within it.
  Image image = picture({1, 1}, {0});
  image.channels.push_back({"ambient2.Y", {0}});
  image.channels.push_back({"ambient.deep.Y", {0}});
  image.channels.push_back({"stderr.ambient.Y", {0}});
  for (const std::string layer : {"ambient", "ambient.Y"}) {
    const LayerPair pair = pairOf(image, image, layer);
    ASSERT_EQ(pair.channels.size(), 1u);
    EXPECT_EQ(pair.channels[0].name, "ambient.Y");
  }
  EXPECT_EQ(pairOf(image, image, "stderr.ambient").channels[0].name, "stderr.ambient.Y");
}

TEST(LayerPair, StandardErrorsMustBeNumbers) {
  // A standard error that is NaN or below 0 where something is compared makes the file unusable; elsewhere it may be.
  const Image got = picture({2, 1}, {0, 0});
  for (const float bad : {kNan, kInf, -1.0f}) {
    Image want = got;
    want.channels.push_back({"stderr.ambient.Y", {0, bad}});
    EXPECT_THAT(messageOf<InputError>([&] { pairOf(got, want); }), HasSubstr("at pixel (1, 0)"));
    channelOf(want, "Z")[1] = kInf;
    EXPECT_EQ(compare(got, want).measures[0].noise, 0.0);
  }
}

TEST(LayerPair, DifferentCamerasAreNoted) {
  // Files that both say their camera, and not the same, are compared with a note; otherwise there is none.
  Image got = picture({1, 1}, {0}), want = got;
  EXPECT_TRUE(compare(got, want).notes.empty());
  got.metadata = {{"isolume:camera", "--eye 0,0,1"}};
  EXPECT_TRUE(compare(got, want).notes.empty());
  want.metadata = {{"isolume:camera", "--eye 0,0,2"}};
  EXPECT_THAT(comparisonText(compare(got, want)), HasSubstr("taken by different cameras"));
  want.metadata = got.metadata;
  EXPECT_TRUE(compare(got, want).notes.empty());
}

}  // namespace
}  // namespace isolume::test
