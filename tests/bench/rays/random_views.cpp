#include "tests/bench/rays/random_views.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/trigonometric.hpp>

#include "tests/reference/random_rays.h"

namespace isolume::bench {
namespace {

using test::Random;

Camera framed(const ViewedBox& box, Random& random, Projection projection) {
  Framing framing;
  framing.azimuthDegrees = random.uniform(0, 360);
  framing.elevationDegrees = random.uniform(-85, 85);
  framing.rollDegrees = random.uniform(0, 360);
  framing.fovDegrees = random.uniform(15, 60);
  framing.projection = projection;
  const double aspect = static_cast<double>(kViewSize.x) / kViewSize.y;
  return frameCorners(boxCorners(glm::dmat4(1), box.solidLow, box.solidHigh), aspect, framing);
}

Camera placed(glm::dvec3 eye, glm::dvec3 target, double fovDegrees, Random& random) {
  Camera camera;
  camera.eye = eye;
  camera.target = target;
  camera.up = random.direction();
  camera.fovDegrees = fovDegrees;
  return camera;
}

// Less than a voxel before a random face.
glm::dvec3 atFace(const ViewedBox& box, Random& random) {
  glm::dvec3 eye = random.pointIn(glm::dvec3(0), box.high);
  const int axis = random.below(3);
  const double before = random.uniform(0, 1);
  eye[axis] = random.below(2) == 0 ? -before : box.high[axis] + before;
  return eye;
}

Camera alongAxis(const ViewedBox& box, Random& random) {
  Camera camera;
  const int axis = random.below(3), side = random.below(2) == 0 ? -1 : 1;
  camera.target = glm::floor(0.5 * (box.solidLow + box.solidHigh));
  camera.eye = camera.target;
  camera.eye[axis] += side * glm::length(box.high);
  camera.up = glm::dvec3(0);
  camera.up[(axis + 1) % 3] = 1;
  camera.projection = Projection::orthographic;
  camera.heightWorld = kViewSize.y / 2.0;  // a pixel is half a voxel, its centre a quarter off
  return camera;
}

}  // namespace

const char* viewKindName(int kind) {
  constexpr std::array<const char*, kViewKinds> kNames{"perspective",   "orthographic", "close",  "within the box",
                                                       "at the border", "far",          "detail", "along an axis"};
  return kNames[static_cast<std::size_t>(kind)];
}

Camera randomView(const ViewedBox& box, std::uint64_t number) {
  Random random(number);
  const double diagonal = glm::length(box.high);
  const auto inSolidBox = [&] { return random.pointIn(box.solidLow, box.solidHigh); };
  const auto wide = [&] { return random.uniform(40, 100); };
  switch (number % kViewKinds) {
    case 0:
      return framed(box, random, Projection::perspective);
    case 1:
      return framed(box, random, Projection::orthographic);
    case 2: {
      const glm::dvec3 eye = 0.5 * box.high + random.uniform(0.52, 0.8) * diagonal * random.direction();
      return placed(eye, inSolidBox(), wide(), random);
    }
    case 3: {
      const glm::dvec3 eye = random.pointIn(glm::dvec3(0), box.high);
      return placed(eye, inSolidBox(), wide(), random);
    }
    case 4:
      return placed(atFace(box, random), inSolidBox(), wide(), random);
    case 5: {
      const glm::dvec3 target = inSolidBox();
      const double away = diagonal * std::pow(10.0, random.uniform(2, 5));
      const double height = diagonal * random.uniform(0.2, 1);
      return placed(target + away * random.direction(), target, glm::degrees(2 * std::atan(height / 2 / away)), random);
    }
    case 6: {
      const glm::dvec3 target = inSolidBox();
      Camera camera = placed(target + diagonal * random.direction(), target, 0, random);
      const double height = random.uniform(4, 30);
      camera.projection = random.below(2) == 0 ? Projection::orthographic : Projection::perspective;
      camera.heightWorld = height;
      camera.fovDegrees = glm::degrees(2 * std::atan(height / 2 / diagonal));
      return camera;
    }
    default:
      return alongAxis(box, random);
  }
}

}  // namespace isolume::bench
