// The samples of a file without a header of its own, wherever their description came from: a name, options, .mhd,
// .nhdr.
#pragma once

#include <cstdint>
#include <glm/gtc/type_precision.hpp>
#include <glm/mat4x4.hpp>
#include <string>

#include "samples.h"
#include "volume.h"

namespace isolume {

struct RawDescription {
  std::string dataPath;
  glm::i64vec3 dims{0};
  SampleType type = SampleType::uint8;
  bool bigEndian = false;
  std::uint64_t offset = 0;  ///< bytes before the first sample
  bool compressed = false;   ///< the samples are one zlib or gzip stream, which begins at `offset`
  bool trailing = false;     ///< bytes may follow the samples, as some writers of attached headers leave them
  bool dataAtEnd = false;    ///< the samples are the file's last bytes, whatever comes before; `offset` is not used
  glm::dmat4 worldFromGrid{1};
};

/// Values, valueOffset, worldFromGrid, sampleType, files (the data file) and notes; the caller adds the rest.
/// InputError unless the file holds exactly the bytes that the description says. Reads and converts in parallel, except
/// for a compressed stream, which one thread unpacks to memory first.
Volume readRawSamples(const RawDescription& description);

}  // namespace isolume
