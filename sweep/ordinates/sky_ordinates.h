// Skies as ordinates: directions that each stand for a share of the sphere, with the light that comes from it.
//
// The value of an ordinate is (1 / pi) times the integral of L |w_k . w| dw over its share, so that E / pi of a point
// that sees the whole hemisphere is that of the sky itself but for the shares that the horizon cuts, which lose 1 / K
// of a white map. Nothing else is lost: each part of the sky belongs to the ordinate closest to it.
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <vector>

#include "surface_rays.h"
#include "sweep/octants.h"

namespace isolume {

/// Relative luminance of linear Rec. 709 primaries.
inline constexpr glm::dvec3 kLuminance{0.2126, 0.7152, 0.0722};

/// A uniform sky of radiance 1 in channel 0: K equal shares whose clamped cosines add up to 1 for an open point.
std::vector<Ordinate> uniformSky(int count);

/// A sky of three bands whose radiance changes linearly with the height z of a direction: channel 0 max(z, 0) (the
/// zenith's share), 1 1 - |z| (the horizon's), 2 max(-z, 0) (the ground's). They add up to the uniform sky.
std::vector<Ordinate> bandedSky(int count, glm::dmat3 axesFromWorld);

/// The eight octants of the grid's axes, each of a radiance of its own: where one alone shines, an open point gets its
/// geometry term G_s(N) / pi ([Singh10] Eq. 3). Channel 0; intensities finite and >= 0.
std::vector<Ordinate> octantSky(int count, const std::array<float, kOctantCount>& intensities);

/// An equirectangular map (sweep/reference/environment.h says how it lies in the world), row-major, linear, finite and
/// >= 0, turned by `rotationDegrees` about +z, counter-clockwise seen from above. Three channels. Each ordinate points
/// to the centre of what shines from its share: so a sun stays where it is. Threaded; about 40 ns per
/// texel, and each of 512 x 256 parts of the map that is not black is compared with all ordinates.
std::vector<Ordinate> mappedSky(int count, glm::ivec2 size, const std::vector<glm::vec3>& radiance,
                                double rotationDegrees, glm::dmat3 axesFromWorld);

}  // namespace isolume
