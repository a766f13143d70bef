#include "raymarch/screen/screen_uniforms.h"

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace isolume {

shader::ScreenUniforms makeScreenUniforms(const shader::FrameUniforms& frame, const Camera& camera,
                                          const GridFrame& grid, glm::ivec2 size, glm::vec2 sampleOffset,
                                          const ScreenOcclusion& settings, const ScreenPlan& plan) {
  const double radius = settings.radiusWorld;
  const CameraAxes axes = cameraAxes(camera);
  const double depth = frame.planePoint.w * grid.smallestSpacing / radius;
  const double pixel = glm::length(glm::dvec3(frame.planeX) * grid.spacing) / radius;
  const glm::dmat3 axesFromWorld = glm::transpose(grid.worldFromAxes);
  const glm::dmat3 gridFromWorld(grid.gridFromWorld);
  // A solid without a back: deeper than anything that a neighbourhood asks for.
  const double thickness = settings.thicknessWorld ? *settings.thicknessWorld / radius : shader::kNothingSeen;
  const glm::dvec3 forward = axesFromWorld * axes.forward;

  shader::ScreenUniforms uniforms{};
  uniforms.picture =
      glm::dvec4(0.5 * glm::dvec2(size) - glm::dvec2(sampleOffset), pixel, frame.eye.w > 0 ? 1 / depth : 0);
  uniforms.toX = glm::dvec4(axesFromWorld * axes.right, thickness);
  uniforms.toY = glm::dvec4(axesFromWorld * -axes.up, settings.secondRadius.value_or(0));
  // The grid's centre lies on the plane or behind it, by less than its size.
  const double farSide = 2 * glm::length(glm::dvec3(frame.gridSize) * grid.spacing) / radius;
  uniforms.depthRow = glm::dvec4(forward * grid.spacing / radius, farSide);
  uniforms.indexX = glm::dvec4(gridFromWorld * (axes.right * radius), 0);
  uniforms.indexY = glm::dvec4(gridFromWorld * (axes.up * -radius), 0);
  uniforms.indexZ = glm::dvec4(gridFromWorld * (axes.forward * radius), 0);
  uniforms.toZ = glm::dvec4(forward, glm::length(glm::dvec3(uniforms.indexZ)));
  uniforms.size = glm::ivec4(size, static_cast<int>(plan.samples.size()), settings.interleaving);
  uniforms.modes = glm::ivec4(static_cast<int>(settings.surface), settings.normalisedBySamples ? 1 : 0,
                              settings.clampedToTangent ? 1 : 0, settings.indirect ? 1 : 0);
  constexpr int kWithTerm = 4;  // of shaders/shared/screen_block.h
  uniforms.march = glm::ivec4(plan.march, settings.steps,
                              static_cast<int>(settings.bent) + (settings.geometricTerm ? kWithTerm : 0));
  return uniforms;
}

}  // namespace isolume
