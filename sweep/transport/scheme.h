// What a sweep of light by ordinates is made of: how an ordinate's light comes from voxel to voxel, and what a voxel
// lets through. Both apart from the sweep (openness_transport.h), so that any go together.
#pragma once

#include <array>
#include <glm/vec3.hpp>

namespace isolume {

/// Weights of the light that leaves the seven voxels upwind: entry k, bit i of k + 1 set where it lies one voxel upwind
/// along axis i. They sum to 1.
using UpwindWeights = std::array<float, 7>;

enum class TransportScheme {
  step,            ///< [Singh10] Eq. 6 with the ordinate's own weights: w_i = |d_i| / h_i / sum, the three neighbours
  characteristic,  ///< bilinear on the face that the ray back enters through: four of the seven; less diffusion
};
/// `direction`: unit, world units along the grid's axes, towards the light or away from it.
UpwindWeights upwindWeights(TransportScheme scheme, glm::dvec3 direction, glm::dvec3 spacing);

enum class Transmittance {
  centred,         ///< [Singh10] Eq. 7: a ramp of D over [-h / 2, h / 2], h the smallest spacing
  inside,          ///< the ramp over [-h, 0]: what is outside the surface blocks nothing
  insideByLength,  ///< the same to the power 1 / sum |d_i|: a ray of the step scheme crosses sum |d_i| voxels per
                   ///< length
};
/// tau of Eq. 7 for `distance` in smallest spacings, without its power.
float rampOf(Transmittance model, float distance);
/// The power that an ordinate raises it to.
float powerOf(Transmittance model, glm::dvec3 direction);

}  // namespace isolume
