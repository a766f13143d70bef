// Reading back what the program wrote.
#pragma once

#include <string>
#include <vector>

#include "src/io/image.h"

namespace isolume::test {

/// The channel of that name; the case fails if there is none.
const std::vector<float>& channel(const Image& image, const std::string& name);
std::vector<std::string> channelNames(const Image& image);
/// The value under that key, or "" and a failed case.
std::string metadata(const Image& image, const std::string& key);
/// Same size, same channels, same bits (so that NaN equals itself).
bool sameBits(const Image& a, const Image& b);
/// Words separated by single blanks.
std::vector<std::string> words(const std::string& text);

}  // namespace isolume::test
