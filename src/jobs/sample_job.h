// `isolume sample`: one of the scenes of volumes/scenes.h as a volume file.
#pragma once

#include <string>

namespace isolume {

inline constexpr int kMinSampleSize = 4;     ///< below it a scene is nothing but its corners
inline constexpr int kMaxSampleSize = 2048;  ///< 32 GiB as float32

struct SampleJob {
  std::string name;
  int size = 128;
  std::string output;  ///< .vdb or .raw
  bool quiet = false;
};

/// The scenes' names, separated by ", ".
std::string sampleNameList();

/// UsageError for an unknown name (with a suggestion) and an ending other than .vdb and .raw.
void checkSample(const SampleJob& job);

/// VDB: a level set where the scene's distance is exact, dense otherwise, with the scene's unit cube as its world.
/// Raw: float32, little-endian, x fastest. Prints how the file can be rendered, unless quiet. The same bytes on every
/// machine. OutputError if it cannot be written.
void runSampleJob(const SampleJob& job);

}  // namespace isolume
