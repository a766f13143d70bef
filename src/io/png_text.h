// Key and value pairs in the bytes of a PNG: tEXt chunks where the value is printable ASCII, iTXt (UTF-8) otherwise.
//
// OpenImageIO writes tEXt alone, which is Latin-1 by definition, and renames some keys. [PNG] 11.3.3.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace isolume {

using TextPairs = std::vector<std::pair<std::string, std::string>>;

/// `png` must be a whole PNG; the chunks go right behind its header chunk. Keys as Image::metadata asks for them:
/// anything else is a std::logic_error, as is a value with a NUL, which would cut it short.
std::string insertPngText(std::string_view png, const TextPairs& pairs);

/// The pairs of all tEXt and uncompressed iTXt chunks, in order. Stops quietly where the bytes end or make no sense:
/// whoever decodes the picture reports that.
TextPairs readPngText(std::string_view png);

}  // namespace isolume
