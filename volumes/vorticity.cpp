// A synthetic turbulent vorticity field in the manner of [Singh10] Fig. 4: a tangle of worm-like tubes.
//
// Noise with random phases shows blobs, not tubes: in a real flow, vorticity gathers along lines. So the velocity is
// given by two scalar noise fields a and b of several octaves (Clebsch variables), u = G(a, b) grad b, and its curl is
//
//   w = curl u = exp(-(a^2 + b^2) / c^2) grad a x grad b,   with dG/da = exp(-(a^2 + b^2) / c^2),
//
// which is exactly free of divergence and lives near the lines a = b = 0: closed, winding, and thinner where the noise
// is steeper.
#include <algorithm>
#include <array>
#include <cmath>

#include "gradient_noise.h"
#include "scene_families.h"

namespace isolume {
namespace {

constexpr double kCore = 0.065;     // c
constexpr double kThreshold = 7.0;  // |w| on the surface

struct Octave {
  double amplitude;
  glm::dmat3 lattice;  // noise space from world: a frequency times a rotation
  std::uint64_t seed;
};
using Turbulence = std::array<Octave, 3>;

// Frequencies without a common lattice, and lattices turned against each other, so that no direction stands out.
Turbulence makeTurbulence(glm::dmat3 turn, std::uint64_t seed) {
  constexpr std::array kFrequencies{7.0, 12.7, 23.9}, kAmplitudes{1.0, 0.4, 0.12};
  const glm::dmat3 furtherTurn = glm::dmat3(2, 2, -1, -1, 2, 2, 2, -1, 2) / 3.0;  // a rotation with rational entries
  Turbulence octaves;
  for (std::size_t i = 0; i < octaves.size(); ++i) {
    octaves[i] = {kAmplitudes[i], kFrequencies[i] * turn, seed + i};
    turn = turn * furtherTurn;
  }
  return octaves;
}
const Turbulence kA = makeTurbulence(glm::dmat3(1), 11);
const Turbulence kB = makeTurbulence(glm::dmat3(0, 12, -5, 0, 5, 12, 13, 0, 0) / 13.0, 77);

double valueOf(const Turbulence& octaves, glm::dvec3 p) {
  double sum = 0;
  for (const Octave& octave : octaves) sum += octave.amplitude * gradientNoiseValue(octave.lattice * p, octave.seed);
  return sum;
}

glm::dvec3 gradientOf(const Turbulence& octaves, glm::dvec3 p) {
  glm::dvec3 sum(0);
  for (const Octave& octave : octaves)
    sum += octave.amplitude * (gradientNoise(octave.lattice * p, octave.seed).gradient * octave.lattice);
  return sum;
}

// 1 in the middle, 0 from the border on: a ball with a ragged edge.
double window(glm::dvec3 p) {
  constexpr double kRadius = 0.47, kLargest = 0.49, kSoft = 0.1, kRagged = 0.1, kFrequency = 4;
  constexpr std::uint64_t kSeed = 5;
  const double radius = glm::length(p - glm::dvec3(0.5));
  if (radius >= kLargest) return 0;
  if (radius <= kRadius - kRagged - kSoft) return 1;  // the noise is at most 1 in magnitude
  const double edge = std::min(kLargest, kRadius + kRagged * gradientNoiseValue(kFrequency * p, kSeed));
  const double t = std::clamp((edge - radius) / kSoft, 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

}  // namespace

glm::dvec3 vorticity(glm::dvec3 p) {
  // exp(-30) is 1e-13, which no gradients here lift above the rounding of kThreshold in float: not worth computing.
  constexpr double kNegligible = 30;
  const double a = valueOf(kA, p) / kCore;
  if (a * a > kNegligible) return glm::dvec3(0);
  const double b = valueOf(kB, p) / kCore;
  const double exponent = a * a + b * b;
  if (exponent > kNegligible) return glm::dvec3(0);
  return std::exp(-exponent) * glm::cross(gradientOf(kA, p), gradientOf(kB, p));
}

double vorticityValue(glm::dvec3 p) {
  const double share = window(p);
  return share > 0 ? kThreshold - share * glm::length(vorticity(p)) : kThreshold;
}

}  // namespace isolume
