// Volumes on the GPU: what is read back is what was given, however it was handed over.
#include "raymarch/textures.h"

#include <glad/gl.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "raymarch/context.h"
#include "raymarch/gpu_error.h"

namespace isolume::test {
namespace {

/// An odd size, so that rows do not end at multiples of four bytes.
constexpr glm::ivec3 kSize(5, 3, 7);
constexpr std::size_t kSliceTexels = kSize.x * kSize.y, kTexels = kSliceTexels * kSize.z;

std::vector<std::uint16_t> numbered() {
  std::vector<std::uint16_t> texels(kTexels);
  for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<std::uint16_t>(601 * i + 3);
  return texels;
}

std::vector<std::uint16_t> readBack(const GlTexture& texture) {
  std::vector<std::uint16_t> texels(kTexels);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glGetTextureImage(texture.name(), 0, kR16.format, kR16.type,
                    static_cast<GLsizei>(texels.size() * sizeof(std::uint16_t)), texels.data());
  EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  return texels;
}

TEST(Textures, HoldWhatTheyAreGiven) {
  const auto context = makeContext("osmesa");
  const std::vector<std::uint16_t> texels = numbered();
  EXPECT_EQ(readBack(makeTexture3D("test", kSize, kR16, GL_NEAREST, texels.data())), texels);
  EXPECT_EQ(readBack(makeTextureSlices("test", kSize, kR16, GL_LINEAR, texels.data())), texels);
}

TEST(Textures, SlabsOfAnyThicknessMakeTheSameVolume) {
  // From one slice at a time to more than there are, by a source that keeps one slab alone: each call overwrites what
  // the last gave. Slabs come in order, whole but for the last, and cover each slice once.
  const auto context = makeContext("osmesa");
  const std::vector<std::uint16_t> texels = numbered();
  for (const int most : {1, 2, 3, 6, 7, 100}) {
    std::vector<std::uint16_t> slab;
    int next = 0;
    const SliceSource slices = [&](int begin, int end) -> const void* {
      EXPECT_EQ(begin, next);
      EXPECT_EQ(end, std::min(begin + most, kSize.z));
      next = end;
      slab.assign(texels.begin() + static_cast<std::ptrdiff_t>(kSliceTexels) * begin,
                  texels.begin() + static_cast<std::ptrdiff_t>(kSliceTexels) * end);
      return slab.data();
    };
    EXPECT_EQ(readBack(makeTextureSlices("test", kSize, kR16, GL_NEAREST, most, slices)), texels) << most;
    EXPECT_EQ(next, kSize.z) << most;
  }
}

TEST(Textures, TooManySlicesAreRefusedWithNumbers) {
  // Before anything is asked of the source.
  const auto context = makeContext("osmesa");
  GLint limit = 0;
  glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &limit);
  const SliceSource slices = [](int, int) -> const void* {
    ADD_FAILURE() << "a slab was asked for";
    return nullptr;
  };
  try {
    makeTextureSlices("level", {2, 2, limit + 1}, kR16, GL_NEAREST, 4, slices);
    FAIL() << "no error";
  } catch (const GpuError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("level texture of 2x2x" + std::to_string(limit + 1)), std::string::npos) << text;
    EXPECT_NE(text.find("at most " + std::to_string(limit)), std::string::npos) << text;
  }
}

}  // namespace
}  // namespace isolume::test
