// "Did you mean": the known word nearest to a mistyped one.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace isolume {

/// Least number of insertions, deletions, replacements and swaps of neighbours that turn a into b. O(|a| |b|).
int editDistance(std::string_view a, std::string_view b);

/// "; did you mean WORD?" for the nearest known word, or "" if none is near: at most a third of the letters may differ
/// (and at least one may). Ties: the first.
std::string didYouMean(std::string_view word, const std::vector<std::string>& known);

}  // namespace isolume
