// Pictures against the CPU tracer: the same pixels are hit, at the same place, with the same normal.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include "gl/gl_scene.h"
#include "support/cpu_tracer.h"
#include "sweep/level.h"
#include "sweep/occlusion_sweep.h"
#include "volumes/scenes.h"

namespace isolume::test {
namespace {

// A pixel within this many pixels of a silhouette may go either way: the shader's float positions are good to about
// 1e-5 voxel in these grids, a pixel is about half a voxel wide, and where the surface turns away an error of e along
// the depth moves the silhouette by far less than e.
constexpr double kSilhouette = 1e-3;
// What the product promises is 1e-3 voxel; what these small grids allow is ten times better.
constexpr double kHitTolerance = 1e-4;
// Hardware filters may shift the point by 1/512 voxel; the normal turns by that times the curvature (at most 1/4 here).
constexpr double kNormalTolerance = 1e-3;

std::optional<bool> certainHit(const GlScene& scene, const Camera& camera, glm::ivec2 size, glm::ivec2 pixel) {
  const auto hit = [&](glm::dvec2 at) {
    return traceLevel(scene.level.view(), pixelRay(camera, size, at, scene.worldFromGrid)).has_value();
  };
  const glm::dvec2 centre = glm::dvec2(pixel) + 0.5;
  const bool found = hit(centre);
  for (const glm::dvec2 offset : {glm::dvec2(1, 0), glm::dvec2(-1, 0), glm::dvec2(0, 1), glm::dvec2(0, -1)}) {
    if (hit(centre + kSilhouette * offset) != found) return std::nullopt;
  }
  return found;
}

void expectAsTraced(const GlScene& scene, const Camera& camera, const RenderSettings& settings) {
  const Frame frame = renderOnce(scene, camera, settings);
  GridView<const float> level = scene.level.view();
  const glm::dmat4 gridFromWorld = glm::inverse(scene.worldFromGrid);
  glm::dmat3 axes(scene.worldFromGrid);
  for (int axis = 0; axis < 3; ++axis) axes[axis] = glm::normalize(axes[axis]);
  int uncertain = 0, hits = 0;
  double worstHit = 0, worstNormal = 0, worstPath = 0;
  for (int y = 0; y < settings.size.y; ++y) {
    for (int x = 0; x < settings.size.x; ++x) {
      const std::size_t i = static_cast<std::size_t>(y * settings.size.x + x);
      const bool found = std::isfinite(frame.depth[i]);
      const auto certain = certainHit(scene, camera, settings.size, {x, y});
      uncertain += !certain;
      if (certain) {
        ASSERT_EQ(found, *certain) << "pixel " << x << ", " << y;
      }
      if (!found) continue;
      ++hits;
      const glm::dvec3 p(gridFromWorld * glm::dvec4(glm::dvec3(frame.position[i]), 1));
      const IndexRay ray = pixelRay(camera, settings.size, glm::dvec2(x, y) + 0.5, scene.worldFromGrid);
      const auto traced = traceLevel(level, ray);
      if (traced && traced->capAxis >= 0) continue;
      const glm::dvec3 physical = gradientAt(level, p);
      worstHit = std::max(worstHit, std::abs(levelAt(level, p)) / glm::length(physical * level.spacing));
      const glm::dvec3 normal = glm::normalize(axes * -physical);
      worstNormal = std::max(worstNormal, glm::length(normal - glm::dvec3(frame.normal[i])));
      // Where the ray meets the surface at a steep enough angle, the first hit is a well-conditioned point.
      const double facing = std::abs(glm::dot(glm::normalize(axes * (level.spacing * ray.direction)), normal));
      if (traced && certain && facing > 0.3)
        worstPath = std::max(worstPath, glm::length(traced->position - p) * facing);
    }
  }
  EXPECT_GT(hits, settings.size.x * settings.size.y / 20);
  EXPECT_LE(uncertain, settings.size.x * settings.size.y / 200);
  EXPECT_LT(worstHit, kHitTolerance);
  EXPECT_LT(worstNormal, kNormalTolerance);
  EXPECT_LT(worstPath, 3 * kHitTolerance);
}

TEST(Coverage, SphereInPerspective) {
  // Every pixel of a sphere agrees with the tracer in coverage, position and normal.
  const GlScene scene = makeSphere();
  expectAsTraced(scene, frameScene(scene), layerSettings());
}

TEST(Coverage, SphereOrthographic) {
  // The same without perspective.
  const GlScene scene = makeSphere();
  expectAsTraced(scene, frameScene(scene, {.projection = Projection::orthographic}), layerSettings());
}

TEST(Coverage, RaysAlongTheAxes) {
  // Directions with components of exactly 0, where 1 / direction is not finite.
  const GlScene scene = makeSphere();
  for (const double azimuth : {0., 90., 180.}) {
    expectAsTraced(
        scene,
        frameScene(scene, {.azimuthDegrees = azimuth, .elevationDegrees = 0, .projection = Projection::orthographic}),
        layerSettings(60, 48));
  }
  expectAsTraced(
      scene, frameScene(scene, {.azimuthDegrees = 0, .elevationDegrees = 90, .projection = Projection::orthographic}),
      layerSettings(60, 48));
}

TEST(Coverage, AnisotropicSpacing) {
  // Voxels 1 : 0.4 : 3 show the same sphere as the tracer sees in physical space.
  const GlScene scene = makeSphere(40, 9.1, {1, 0.4, 3});
  expectAsTraced(scene, frameScene(scene, {.zoom = 2.5}), layerSettings());
}

TEST(Coverage, RotatedReflectedFarAway) {
  // A grid turned, mirrored and a million units from the origin: positions only as exact as float world coordinates
  // are, so coverage and normals are compared through a scene near the origin.
  const GlScene scene = makeSphere();
  const Camera camera = frameScene(scene);
  const Frame frame = renderOnce(scene, camera, layerSettings());
  GlScene moved = makeSphere();
  glm::dmat4 motion = glm::translate(glm::dmat4(1), glm::dvec3(1e6, -1e6, 1e6));
  motion = glm::rotate(motion, 0.7, glm::normalize(glm::dvec3(1, 2, 3)));
  moved.worldFromGrid = motion;
  Camera movedCamera = camera;
  movedCamera.eye = glm::dvec3(motion * glm::dvec4(camera.eye, 1));
  movedCamera.target = glm::dvec3(motion * glm::dvec4(camera.target, 1));
  movedCamera.up = glm::dmat3(motion) * camera.up;
  const Frame same = renderOnce(moved, movedCamera, layerSettings());
  int differing = 0;
  for (std::size_t i = 0; i < frame.color.size(); ++i) {
    differing += !(glm::length(frame.color[i] - same.color[i]) < 1e-4f);
  }
  // Rays differ in the last float bit, so only those that graze the silhouette may differ.
  EXPECT_LE(differing, 4);

  // Mirrored in x, the picture is that of a mirrored camera, column by column.
  GlScene mirrored = makeSphere();
  mirrored.worldFromGrid[0] = -mirrored.worldFromGrid[0];
  const glm::dvec3 flip(-1, 1, 1);
  Camera mirroredCamera = camera;
  mirroredCamera.eye *= flip;
  mirroredCamera.target *= flip;
  mirroredCamera.up *= flip;
  const Frame reflected = renderOnce(mirrored, mirroredCamera, layerSettings());
  differing = 0;
  for (int y = 0; y < frame.size.y; ++y) {
    for (int x = 0; x < frame.size.x; ++x) {
      const std::size_t i = static_cast<std::size_t>(y * frame.size.x + x);
      const std::size_t j = static_cast<std::size_t>(y * frame.size.x + frame.size.x - 1 - x);
      differing += !(glm::length(frame.color[i] - reflected.color[j]) < 1e-4f) ||
                   !(glm::length(frame.normal[i] - reflected.normal[j] * glm::vec3(-1, 1, 1)) < 1e-3f);
    }
  }
  EXPECT_LE(differing, 4);
}

TEST(Coverage, SampleScenesWithTheSweptDistance) {
  // On the sample scenes, with the distance that the sweep really gives (it overestimates), no ray leaps over anything.
  for (const char* name : {"corner", "gyroid", "capsules", "capillaries"}) {
    SCOPED_TRACE(name);
    constexpr int kSize = 48;
    GlScene scene;
    scene.level = sampleScene(*findScene(name), kSize);
    makeLevel(scene.level.view(), 0, Inside::below);
    SweptFields swept = sweepOcclusion(scene.level.view());
    scene.distance = std::move(swept.distance);
    scene.octants = std::move(swept.visibility.packed);
    for (int axis = 0; axis < 3; ++axis) scene.worldFromGrid[axis][axis] = 1.0 / kSize;
    // Capsules of 0.9 voxels' radius: normals are differences over whole structures, and grazing pixels are many.
    const Frame frame = renderOnce(scene, frameScene(scene), layerSettings());
    const Camera camera = frameScene(scene);
    int uncertain = 0;
    for (int y = 0; y < frame.size.y; ++y) {
      for (int x = 0; x < frame.size.x; ++x) {
        const auto certain = certainHit(scene, camera, frame.size, {x, y});
        uncertain += !certain;
        const bool found = std::isfinite(frame.depth[static_cast<std::size_t>(y * frame.size.x + x)]);
        if (certain) {
          ASSERT_EQ(found, *certain) << "pixel " << x << ", " << y;
        }
      }
    }
    EXPECT_LE(uncertain, frame.size.x * frame.size.y / 100);
  }
}

}  // namespace
}  // namespace isolume::test
