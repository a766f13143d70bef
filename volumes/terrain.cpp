#include "gradient_noise.h"
#include "scene_families.h"

namespace isolume {

double terrainHeight(double x, double y) {
  constexpr double kMean = 0.4;
  // Each octave is half as wide and less than half as high as the one before, so that slopes stay moderate.
  constexpr double kHills = 4, kHillHeight = 0.12, kNarrowing = 2, kFlattening = 0.4;
  constexpr int kOctaves = 3;
  double height = kMean, share = kHillHeight, frequency = kHills;
  for (int octave = 0; octave < kOctaves; ++octave) {
    height += share * gradientNoiseValue({frequency * x, frequency * y, 0.5}, static_cast<std::uint64_t>(octave));
    share *= kFlattening;
    frequency *= kNarrowing;
  }
  return height;
}

double terrainValue(glm::dvec3 p) { return p.z - terrainHeight(p.x, p.y); }

}  // namespace isolume
