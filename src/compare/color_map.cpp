#include "src/compare/color_map.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>

namespace isolume {
namespace {

/// L*, a*, b* at t = -1, -1/2, 0, 1/2, 1.
const std::array<glm::dvec3, 5> kControlPoints{{{38, 10, -46}, {67, -4, -30}, {96, 0, 0}, {67, 22, 48}, {38, 28, 45}}};

/// The inverse of CIELAB's f: cubic, and a straight line below 6/29.
double inverseF(double f) {
  constexpr double kKnee = 6.0 / 29, kOffset = 4.0 / 29;
  return f > kKnee ? f * f * f : 3 * kKnee * kKnee * (f - kOffset);
}

glm::dvec3 linearSrgbFromLab(glm::dvec3 lab) {
  const double fy = (lab.x + 16) / 116, fx = fy + lab.y / 500, fz = fy - lab.z / 200;  // [CIE15]
  const glm::dvec3 kWhiteD65(.95047, 1, 1.08883);
  const glm::dvec3 xyz = kWhiteD65 * glm::dvec3(inverseF(fx), inverseF(fy), inverseF(fz));
  const glm::dmat3 kSrgbFromXyz(3.2404542, -.9692660, .0556434,  // columns; IEC 61966-2-1
                                -1.5371385, 1.8760108, -.2040259, -.4985314, .0415560, 1.0572252);
  return kSrgbFromXyz * xyz;
}

}  // namespace

glm::vec3 divergingColor(double t) {
  assert(!std::isnan(t));
  constexpr double kSegments = kControlPoints.size() - 1;
  const double along = (std::clamp(t, -1.0, 1.0) + 1) / 2 * kSegments;
  const auto segment = static_cast<std::size_t>(std::min(std::floor(along), kSegments - 1));
  const glm::dvec3 lab =
      glm::mix(kControlPoints[segment], kControlPoints[segment + 1], along - static_cast<double>(segment));
  return glm::vec3(glm::clamp(linearSrgbFromLab(lab), 0.0, 1.0));
}

}  // namespace isolume
