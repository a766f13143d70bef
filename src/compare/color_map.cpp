#include "src/compare/color_map.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <glm/common.hpp>
#include <glm/mat3x3.hpp>

namespace isolume {
namespace {

/// L*, a*, b*, evenly from one end of a map to the other.
const std::array<glm::dvec3, 5> kDiverging{{{38, 10, -46}, {67, -4, -30}, {96, 0, 0}, {67, 22, 48}, {38, 28, 45}}};

const std::array<glm::dvec3, 5> kSequential{
    {{20, 30, -36}, {37.75, 0, -32}, {55.5, -28, -6}, {73.25, -36, 38}, {91, -10, 72}}};

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

/// `along` in [0, 1].
glm::vec3 between(const std::array<glm::dvec3, 5>& points, double along) {
  const auto segments = static_cast<double>(points.size() - 1);
  const double place = along * segments;
  const auto segment = static_cast<std::size_t>(std::min(std::floor(place), segments - 1));
  const glm::dvec3 lab = glm::mix(points[segment], points[segment + 1], place - static_cast<double>(segment));
  return glm::vec3(glm::clamp(linearSrgbFromLab(lab), 0.0, 1.0));
}

}  // namespace

glm::vec3 divergingColor(double t) {
  assert(!std::isnan(t));
  return between(kDiverging, (std::clamp(t, -1.0, 1.0) + 1) / 2);
}

glm::vec3 sequentialColor(double t) {
  assert(!std::isnan(t));
  return between(kSequential, std::clamp(t, 0.0, 1.0));
}

}  // namespace isolume
