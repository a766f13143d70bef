// The sky as a cube map for the screen-space passes: radiance from every direction, along the axes of the grid.
//
// Faces and texels lie as OpenGL has them: +x -x +y -y +z -z, each row-major. A texel holds the mean radiance over its
// solid angle, so that light is neither lost nor made however fine a map was; what is finer than 1.4 degrees is
// blurred. 288 KiB. Thread-safe.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace isolume {

/// Texels along each edge of a face, and faces.
inline constexpr int kSkySide = 64, kCubeFaces = 6;

struct SkyCube {
  int side = kSkySide;
  std::vector<glm::vec3> radiance = std::vector<glm::vec3>(kCubeFaces * kSkySide * kSkySide, glm::vec3(0));
};

/// Unit vector to a place on a face, `at` in texels from its corner: the centre of texel (i, j) is (i + 1/2, j + 1/2).
glm::dvec3 cubeDirection(int side, int face, glm::dvec2 at);
/// To the centre of a texel, by its index.
glm::dvec3 cubeTexelDirection(int side, std::size_t texel);
/// Of a direction of any length but 0: the index of its texel.
std::size_t cubeTexel(int side, glm::dvec3 direction);
/// Steradians of the texels of one face, row-major.
std::vector<double> cubeSolidAngles(int side);

void addEvenSky(SkyCube& sky, glm::vec3 radiance);

/// Bands as of bandedSky() (sweep/ordinates/sky_ordinates.h): zenith, horizon, ground.
void addBandedSky(SkyCube& sky, glm::vec3 zenith, glm::vec3 horizon, glm::vec3 ground, glm::dmat3 worldFromAxes);

/// An equirectangular map as of mappedSky(), times `scale`. Each of its texels goes to the texel of the cube that its
/// centre lies in; texels wider than a third of a degree are cut into parts. Threaded; about 30 ns per texel.
void addMappedSky(SkyCube& sky, glm::ivec2 size, const std::vector<glm::vec3>& radiance, double rotationDegrees,
                  float scale, glm::dmat3 worldFromAxes);

/// The same sky with half as many texels along each edge.
SkyCube halvedSky(const SkyCube& sky);

}  // namespace isolume
