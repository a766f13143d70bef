// Small scenes with known distance for the tests of the renderer.
#pragma once

#include <functional>
#include <glm/mat4x4.hpp>

#include "raymarch/renderer.h"
#include "sweep/ordinates/surface_field.h"

namespace isolume::test {

/// Everything a renderer is given, owned.
struct GlScene {
  Grid<float> level, distance;
  std::array<Grid<glm::u8vec4>, 2> octants;
  SurfaceField openness;  ///< the one light field, if there is any
  glm::dmat4 worldFromGrid{1};
  SceneFields fields() const;
};

/// distance(p) in grid-aligned physical space (p = spacing * index), < 0 inside, exact or below the true magnitude. The
/// level is its negative. All octants are open (255), and so is the openness (65535). The world is grid-aligned space.
GlScene makeScene(glm::ivec3 size, glm::dvec3 spacing, const std::function<double(glm::dvec3)>& distance);

/// A sphere about the middle of a cube of n samples; off the samples' symmetry by an odd shift.
GlScene makeSphere(int n = 48, double radius = 17.3, glm::dvec3 spacing = glm::dvec3(1));
glm::dvec3 sphereCentre(int n, glm::dvec3 spacing = glm::dvec3(1));

Camera frameScene(const GlScene& scene, const Framing& framing = {});

/// Local shading, with layers.
RenderSettings layerSettings(int width = 120, int height = 96);

/// Uploads and renders once on a fresh OSMesa context.
Frame renderOnce(const GlScene& scene, const Camera& camera, const RenderSettings& settings);

}  // namespace isolume::test
