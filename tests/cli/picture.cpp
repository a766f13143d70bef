#include "cli/picture.h"

#include <gtest/gtest.h>

#include <cstring>
#include <sstream>

namespace isolume::test {

const std::vector<float>& channel(const Image& image, const std::string& name) {
  for (const ImageChannel& each : image.channels)
    if (each.name == name) return each.values;
  ADD_FAILURE() << "no channel " << name;
  static const std::vector<float> none;
  return none;
}

std::vector<std::string> channelNames(const Image& image) {
  std::vector<std::string> names;
  for (const ImageChannel& each : image.channels) names.push_back(each.name);
  return names;
}

std::string metadata(const Image& image, const std::string& key) {
  for (const auto& [name, value] : image.metadata)
    if (name == key) return value;
  ADD_FAILURE() << "no metadata " << key;
  return {};
}

bool sameBits(const Image& a, const Image& b) {
  if (a.size != b.size || channelNames(a) != channelNames(b)) return false;
  for (std::size_t i = 0; i < a.channels.size(); ++i) {
    const std::vector<float>&x = a.channels[i].values, &y = b.channels[i].values;
    if (x.size() != y.size() || std::memcmp(x.data(), y.data(), x.size() * sizeof(float)) != 0) return false;
  }
  return true;
}

std::vector<std::string> words(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> list;
  for (std::string word; stream >> word;) list.push_back(word);
  return list;
}

}  // namespace isolume::test
