// A bitmap font for numbers: 0 to 9, + - . and e, in cells of 5 x 7 pixels.
#pragma once

#include <string_view>

namespace isolume {

constexpr int kGlyphWidth = 5, kGlyphHeight = 7;
constexpr int kGlyphAdvance = kGlyphWidth + 1;  ///< from one letter to the next

/// Whether pixel (x, y) of a letter is ink; (0, 0) is its upper left. False outside the cell and for other letters.
bool glyphInk(char letter, int x, int y);

/// Pixels from the left of the first letter to the right of the last.
int textWidth(std::string_view text);

}  // namespace isolume
