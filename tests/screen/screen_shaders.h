// The estimators of shaders/screen compiled as C++, asking a scene of half-spaces instead of a G-buffer: seen along z
// in parallel, at unlimited resolution.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

#include "raymarch/screen/screen_plan.h"
#include "raymarch/screen/sky_draws.h"

namespace isolume::glsl {

using namespace glm;

/// What the estimators ask. The frame is that of the shaded point, lengths in radii.
struct Asked {
  std::vector<vec4> samples;
  ivec2 march{0};
  bool normalised = true, clamped = true;
  float thickness = 1e9f;
  int steps = 0;
  mat3 gridFromFrame{1};
  std::vector<vec4> draws = {};                                ///< of sky_draws.h
  std::function<vec3(vec3)> skyRadiance = {}, openLight = {};  ///< axes of the grid
  std::function<float(float x, float y)> depth;                ///< of the surface that is seen
};
inline Asked asked;

inline int sampleCount() { return static_cast<int>(asked.samples.size()); }
inline vec4 sampleAt(int i) { return asked.samples[static_cast<std::size_t>(i)]; }
inline ivec2 marchCounts() { return asked.march; }
inline int marchSteps() { return asked.steps; }
inline vec3 gridDirection(vec3 v) { return asked.gridFromFrame * v; }
inline vec3 frameDirection(vec3 v) { return transpose(asked.gridFromFrame) * v; }
inline vec4 skyTexel(int cell, int i) { return asked.draws[static_cast<std::size_t>(cell * (1 + 2 * kCellDraws) + i)]; }
inline vec3 skyRadiance(vec3 direction) { return asked.skyRadiance(direction); }
inline vec3 openLight(vec3 normal) { return asked.openLight(normal); }
inline bool normalisedBySamples() { return asked.normalised; }
inline bool clampedToTangent() { return asked.clamped; }
inline float seenThickness() { return asked.thickness; }
inline vec3 seenPoint(vec3 p) { return vec3(p.x, p.y, asked.depth(p.x, p.y)); }

#include "shaders/screen/view.glsl"

#include "shaders/screen/shaded.glsl"

inline float outside(vec3 p) {
  const float kRounding = 1e-5f;  // points of a plane lie on it
  const float depth = asked.depth(p.x, p.y);
  return p.z <= depth + kRounding || p.z > depth + asked.thickness ? 1.0f : 0.0f;
}
inline OuterParts outerParts(vec2 at, float near, float far) {
  return partsAround(asked.depth(at.x, at.y), asked.thickness, near, far);
}

/// Of a square of that area, by a grid of its points.
inline DepthSpread depthSpread(vec2 at, float share) {
  const int kSide = 8;
  const float kPi = 3.141592654f;
  const float side = std::sqrt(kPi * share);
  float sum = 0, squares = 0;
  for (int i = 0; i < kSide * kSide; ++i) {
    const float x = (static_cast<float>(i % kSide) + 0.5f) / kSide - 0.5f;
    const float y = (static_cast<float>(i / kSide) + 0.5f) / kSide - 0.5f;
    const float depth = asked.depth(at.x + side * x, at.y + side * y);
    sum += depth;
    squares += depth * depth;
  }
  const float mean = sum / (kSide * kSide);
  return DepthSpread{mean, std::sqrt(max(squares / (kSide * kSide) - mean * mean, 0.0f))};
}

#include "shaders/screen/horizon.glsl"

#include "shaders/screen/ball_line.glsl"

#include "shaders/screen/area.glsl"

#include "shaders/screen/bent.glsl"
#include "shaders/screen/march_to.glsl"

#include "shaders/screen/bent_points.glsl"
#include "shaders/screen/bitmask.glsl"
#include "shaders/screen/disk.glsl"
#include "shaders/screen/gtao.glsl"
#include "shaders/screen/hbao.glsl"
#include "shaders/screen/importance.glsl"
#include "shaders/screen/line.glsl"
#include "shaders/screen/points.glsl"
#include "shaders/screen/ssdo.glsl"
#include "shaders/screen/volumetric.glsl"

}  // namespace isolume::glsl
