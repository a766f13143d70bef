#include "row_contents.h"

#include <algorithm>

#include "sweep/parallel.h"

namespace isolume {

RowContents::RowContents(GridView<const float> distance, const TransmittanceRamp& ramp)
    : distance_(distance),
      ramp_(ramp),
      perSmallest_(1 / static_cast<float>(smallestSpacing(distance.spacing))),
      parts_((distance.size.x + kSegment - 1) / kSegment),
      contents_(firstOf(0, distance.size.z)) {
  parallelFor(static_cast<std::size_t>(distance.size.z), [&](std::size_t z) {
    std::vector<std::int16_t> row(static_cast<std::size_t>(parts_ * kSegment + columnLanes()));
    for (int y = 0; y < distance.size.y; ++y) {
      convert(y, static_cast<int>(z), 0, parts_, row.data());
      for (int i = 0; i < parts_; ++i) {
        const auto begin = row.begin() + static_cast<std::ptrdiff_t>(i) * kSegment;
        const auto [least, most] = std::minmax_element(begin, begin + kSegment);
        contents_[firstOf(y, static_cast<int>(z)) + static_cast<std::size_t>(i)] = *most == kClear ? Part::clear
                                                                                   : *least == 0   ? Part::dark
                                                                                                   : Part::several;
      }
    }
  });
}

void RowContents::convert(int y, int z, int first, int end, std::int16_t* row) const {
  const int x = first * kSegment, count = std::min(end * kSegment, distance_.size.x) - x;
  transmittanceRow(&distance_(x, y, z), count, perSmallest_, ramp_, row + x);
}

void RowContents::writeRow(int y, int z, std::int16_t* row) const {
  const Part* parts = contents_.data() + firstOf(y, z);
  for (int i = 0; i < parts_; ++i) {
    if (parts[i] != Part::several) continue;
    int end = i + 1;
    while (end < parts_ && parts[end] == Part::several) ++end;
    convert(y, z, i, end, row);
    i = end;
  }
  // After those, which are written in whole vectors.
  for (int i = 0; i < parts_; ++i)
    if (parts[i] != Part::several)
      std::fill_n(row + static_cast<std::ptrdiff_t>(i) * kSegment, kSegment, parts[i] == Part::clear ? kClear : 0);
}

}  // namespace isolume
