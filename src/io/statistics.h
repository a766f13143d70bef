// What `info` prints about the samples of a volume, and the isovalue that `render` takes by default.
#pragma once

#include <array>
#include <cstddef>
#include <string>

#include "volume.h"

namespace isolume {

struct VolumeStatistics {
  std::size_t count = 0, nanCount = 0, infCount = 0;
  double min = 0, max = 0, mean = 0;         ///< of the finite samples, true values (offset added)
  std::array<std::size_t, 256> histogram{};  ///< equal bins over [min, max], finite samples
};
VolumeStatistics computeStatistics(const Volume& volume);

/// Isovalue and why: 0 for a VDB level set, 0.5 for bool, else Otsu's threshold of the histogram ([Otsu79]).
struct IsovalueChoice {
  double isovalue = 0;
  std::string reason;
};
IsovalueChoice defaultIsovalue(const Volume& volume, const VolumeStatistics& statistics);

}  // namespace isolume
