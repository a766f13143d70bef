// Pictures made of numbers, for the comparison.
#pragma once

#include <cmath>
#include <glm/vec3.hpp>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

#include "src/compare/comparison.h"

namespace isolume::test {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();

/// A picture with one layer of one channel; everything is hit (Z = 1).
inline Image picture(glm::ivec2 size, const std::vector<float>& values, const std::string& channel = "ambient.Y") {
  Image image;
  image.size = size;
  image.channels = {{channel, values}, {"Z", std::vector<float>(values.size(), 1.0f)}};
  return image;
}

inline std::vector<float>& channelOf(Image& image, const std::string& name) {
  for (ImageChannel& channel : image.channels)
    if (channel.name == name) return channel.values;
  throw std::logic_error("no channel " + name);
}

/// Adds channels layer.X, .Y, .Z.
inline void addVectors(Image& image, const std::string& layer, const std::vector<glm::vec3>& vectors) {
  for (int i = 0; i < 3; ++i) {
    std::vector<float> values;
    for (const glm::vec3& vector : vectors) values.push_back(vector[i]);
    image.channels.push_back({layer + "." + "XYZ"[i], values});
  }
}

/// Independent values of k / 256, uniform in [0, 1): sums and differences of them are exact.
inline std::vector<float> dyadicNoise(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<float> values(count);
  constexpr unsigned kByte = 256;
  for (float& value : values) value = static_cast<float>(random() % kByte) / kByte;
  return values;
}

inline Image noisePicture(glm::ivec2 size, unsigned seed) {
  return picture(size, dyadicNoise(static_cast<std::size_t>(size.x * size.y), seed));
}

inline LayerPair pairOf(const Image& got, const Image& want, const std::string& layer = "ambient") {
  return pairLayer(layer, {"got.exr", got}, {"want.exr", want});
}
inline Comparison compare(const Image& got, const Image& want, const std::string& layer = "ambient") {
  return compareLayer(pairOf(got, want, layer));
}

}  // namespace isolume::test
