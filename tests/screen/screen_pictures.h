// What tests of pictures lighted from the screen share: a room, cameras on it, and what pictures are judged by.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <string>

#include "gl/gl_scene.h"
#include "raymarch/gpu_error.h"

namespace isolume::test {

inline constexpr double kRadius = 8;  // of the estimators, voxels, spacing 1

/// A floor below z = 20.3 and a wall beyond x = 40.6.
inline constexpr double kFloorHeight = 20.3, kWallX = 40.6;
inline GlScene makeRoom() {
  return makeScene({64, 64, 64}, glm::dvec3(1),
                   [](glm::dvec3 p) { return std::min(p.z - kFloorHeight, kWallX - p.x); });
}
/// Sees floor and wall, everything else being beyond the picture.
inline Camera roomCamera(double roll = 0) {
  Camera camera;
  camera.target = {36, 32, 22};
  camera.eye = camera.target + glm::dvec3(-60, -50, 70);
  camera.rollDegrees = roll;
  camera.fovDegrees = 20;
  return camera;
}

/// Calls visit(pixel, a) for pixels of the room's floor a >= .2 radii from the wall, where they are told from it, and
/// away from the border.
template <class Visit>
void forFloorPixels(const Frame& frame, const Visit& visit) {
  for (std::size_t i = 0; i < frame.light.size(); ++i) {
    const int x = static_cast<int>(i) % frame.size.x, y = static_cast<int>(i) / frame.size.x;
    const int border = std::min({x, y, frame.size.x - 1 - x, frame.size.y - 1 - y});
    const double a = (kWallX - frame.position[i].x) / kRadius;
    if (border < frame.size.x / 5 || frame.normal[i].z < 0.999 || a < 0.2) continue;
    visit(i, a);
  }
}

/// Calls visit(from, to) for the pixels of a picture of side x side, and where they are after the camera rolled by a
/// quarter turn: it turns clockwise, the picture the other way, so that right becomes up.
template <class Visit>
void forRolledPixels(int side, const Visit& visit) {
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      visit(static_cast<std::size_t>(y * side + x), static_cast<std::size_t>((side - 1 - x) * side + y));
}

inline RenderSettings screenSettings(ScreenEstimator estimator, glm::ivec2 size = {200, 160}) {
  RenderSettings settings = layerSettings(size.x, size.y);
  settings.screen = ScreenOcclusion{.estimator = estimator, .radiusWorld = kRadius, .samples = 16};
  return settings;
}

/// Largest and root mean square difference, over the pixels that it is asked of.
struct Differences {
  double largest = 0, square = 0;
  int count = 0;
  void add(double difference) {
    largest = std::max(largest, std::abs(difference));
    square += difference * difference;
    ++count;
  }
  double rms() const { return std::sqrt(square / count); }
};

template <class Layer>
bool sameBits(const Layer& a, const Layer& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
}

class ScreenPictures : public ::testing::Test {
 protected:
  Frame draw(const GlScene& scene, const Camera& camera, const RenderSettings& settings) {
    renderer_.upload(scene.fields());
    return renderer_.render(camera, settings);
  }
  /// Drawing throws a GpuError that contains `text`.
  void expectRefused(const GlScene& scene, const RenderSettings& settings, const char* text) {
    try {
      draw(scene, frameScene(scene), settings);
      ADD_FAILURE() << "no error: " << text;
    } catch (const GpuError& error) {
      EXPECT_NE(std::string(error.what()).find(text), std::string::npos) << error.what();
    }
  }
  std::unique_ptr<Context> context_ = makeContext("osmesa");
  Renderer renderer_{*context_};
};

}  // namespace isolume::test
