#include "src/suggest.h"

#include <fmt/core.h>

#include <algorithm>
#include <utility>

namespace isolume {

int editDistance(std::string_view a, std::string_view b) {
  // Rows of the dynamic programme: distances of the prefixes of b to the prefix of a that is one shorter, two shorter.
  std::vector<int> previous(b.size() + 1), current(b.size() + 1), beforePrevious(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) previous[j] = static_cast<int>(j);
  for (std::size_t i = 1; i <= a.size(); ++i) {
    current[0] = static_cast<int>(i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const int replace = previous[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      current[j] = std::min({replace, previous[j] + 1, current[j - 1] + 1});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        current[j] = std::min(current[j], beforePrevious[j - 2] + 1);
    }
    std::swap(beforePrevious, previous);
    std::swap(previous, current);
  }
  return previous[b.size()];
}

std::string didYouMean(std::string_view word, const std::vector<std::string>& known) {
  const std::string* nearest = nullptr;
  int least = std::max(1, static_cast<int>(word.size()) / 3) + 1;
  for (const std::string& candidate : known) {
    const int distance = editDistance(word, candidate);
    if (distance < least) {
      least = distance;
      nearest = &candidate;
    }
  }
  return nearest ? fmt::format("; did you mean {}?", *nearest) : std::string();
}

}  // namespace isolume
