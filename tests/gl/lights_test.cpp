// Light fields: their values, colours and discs, and the light from the eye.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/trigonometric.hpp>
#include <vector>

#include "gl/gl_scene.h"
#include "raymarch/gpu_error.h"

namespace isolume::test {
namespace {

constexpr int kSize = 32;
constexpr float kFull = 65535;
/// Eight texels of 16 bits, weighed in float.
constexpr double kTolerance = 5e-5;

SurfaceField fieldOf(const std::function<double(glm::dvec3)>& value) {
  Grid<std::uint16_t> field{glm::ivec3(kSize)};
  for (int z = 0; z < kSize; ++z)
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x)
        field.view()(x, y, z) = static_cast<std::uint16_t>(std::lround(kFull * value({x, y, z})));
  return surfaceField(std::as_const(field).view());
}

// A ball, drawn by light fields.
class Lights : public ::testing::Test {
 protected:
  Frame draw(const std::vector<LightField>& fields, const RenderSettings& settings) {
    upload(fields);
    return renderer_.render(camera_, settings);
  }
  void upload(const std::vector<LightField>& fields) {
    SceneFields scene = scene_.fields();
    scene.lights = fields;
    renderer_.upload(scene);
  }
  static RenderSettings settingsWith(std::vector<glm::vec3> colors) {
    RenderSettings settings = layerSettings();
    settings.shading = Shading::lights;
    settings.lightColors = std::move(colors);
    return settings;
  }
  /// The number of a field at a hit.
  double valueAt(const SurfaceField& field, glm::dvec3 position, glm::dvec3 normal) const {
    return wallValueAt(field, scene_.level.view(), position, normal) / kFull;
  }
  /// expected(position, normal) at every hit; true if there were many.
  static bool expectLight(const Frame& frame, const std::function<glm::dvec3(glm::dvec3, glm::dvec3)>& expected) {
    int hits = 0;
    for (std::size_t i = 0; i < frame.depth.size(); ++i) {
      if (!std::isfinite(frame.depth[i])) continue;
      ++hits;
      const glm::dvec3 want = expected(glm::dvec3(frame.position[i]), glm::dvec3(frame.normal[i]));
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(frame.light[i][c], want[c], kTolerance) << i << " channel " << c;
    }
    return hits > 500;
  }

  GlScene scene_ = makeSphere(kSize, 11.3);
  Camera camera_ = frameScene(scene_);
  std::unique_ptr<Context> context_ = makeContext("osmesa");
  Renderer renderer_{*context_};
};

TEST_F(Lights, FieldsAddUpWithTheirColours) {
  // Three fields, each linear along another axis and with its own full value: their sum, each times its colour.
  std::vector<SurfaceField> grids;
  for (int axis = 0; axis < 3; ++axis) grids.push_back(fieldOf([axis](glm::dvec3 p) { return p[axis] / kSize; }));
  const std::vector<LightField> fields{{&grids[0]}, {&grids[1], 0.5F}, {&grids[2], 2}};
  const std::vector<glm::vec3> colors{{1, 0.5, 0}, {0, 0.25, 0.75}, {0.125, 0.25, 0.5}};
  const auto sumOf = [&](const std::vector<glm::vec3>& each, glm::dvec3 p, glm::dvec3 normal) {
    glm::dvec3 sum(0);
    for (std::size_t i = 0; i < fields.size(); ++i)
      sum += static_cast<double>(fields[i].full) * valueAt(grids[i], p, normal) * glm::dvec3(each[i]);
    return sum;
  };
  EXPECT_TRUE(expectLight(draw(fields, settingsWith(colors)),
                          [&](glm::dvec3 p, glm::dvec3 normal) { return sumOf(colors, p, normal); }));
  // Without colours they are white.
  const std::vector<glm::vec3> white(3, glm::vec3(1));
  EXPECT_TRUE(expectLight(draw(fields, settingsWith({})),
                          [&](glm::dvec3 p, glm::dvec3 normal) { return sumOf(white, p, normal); }));
}

TEST_F(Lights, AsManyAsAProgramTakes) {
  // Eight fields of an eighth each add up to one; nine are an error, one line that tells both numbers.
  const SurfaceField eighth = fieldOf([](glm::dvec3) { return 1; });
  const std::vector<LightField> eight(8, LightField{&eighth, 0.125F});
  EXPECT_TRUE(expectLight(draw(eight, settingsWith({})), [](glm::dvec3, glm::dvec3) { return glm::dvec3(1); }));
  EXPECT_THROW(upload(std::vector<LightField>(9, LightField{&eighth})), GpuError);
}

// Mean of max(N . w, 0) over a disc above the horizon.
double wholeDisc(double cosine, double radiusDegrees) {
  return cosine * (1 + std::cos(glm::radians(radiusDegrees))) / 2;
}

TEST_F(Lights, ADiscIsMultipliedWithItsMeanCosine) {
  // Seen in full, a disc gives the mean cosine of its directions, 0 where all of it is below the horizon; times the
  // share that is seen. The direction is the world's, whatever the grid's frame, and of any length.
  constexpr double kRadius = 10, kShare = 0.75;
  const SurfaceField share = fieldOf([](glm::dvec3) { return kShare; });
  const glm::dvec3 towards(0.9, 0.3, 0.2);
  for (const bool turned : {false, true}) {
    if (turned) {
      scene_.worldFromGrid = glm::rotate(glm::dmat4(1), 0.9, glm::normalize(glm::dvec3(1, -2, 0.5)));
      camera_ = frameScene(scene_);
    }
    const Frame frame =
        draw({{.values = &share, .direction = 7.0 * towards, .radiusDegrees = kRadius}}, settingsWith({{1, 0.5, 0}}));
    const double sine = std::sin(glm::radians(kRadius));
    int whole = 0, dark = 0;
    for (std::size_t i = 0; i < frame.depth.size(); ++i) {
      if (!std::isfinite(frame.depth[i])) continue;
      const double cosine = glm::dot(glm::dvec3(frame.normal[i]), glm::normalize(towards));
      const glm::dvec3 light(frame.light[i]);
      EXPECT_NEAR(light.y, light.x / 2, kTolerance);
      EXPECT_EQ(light.z, 0);
      if (cosine > sine) {
        ++whole;
        EXPECT_NEAR(light.x, kShare * wholeDisc(cosine, kRadius), kTolerance);
      } else if (cosine < -sine) {
        ++dark;
        EXPECT_EQ(light.x, 0);
      } else {
        EXPECT_GE(light.x, kShare * wholeDisc(cosine, kRadius) - kTolerance);
        EXPECT_LE(light.x, kShare * wholeDisc(sine, kRadius) + kTolerance);
      }
    }
    EXPECT_GT(whole, 300);
    EXPECT_GT(dark, 100);
  }
}

TEST_F(Lights, HeadLightComesFromTheEye) {
  // |N . V| times its colour, to the eye itself in perspective, on top of the fields; alone too.
  const SurfaceField half = fieldOf([](glm::dvec3) { return 0.5; });
  for (const bool withField : {true, false}) {
    RenderSettings settings = settingsWith({});
    settings.headLight = {0.5, 0.25, 1};
    const std::vector<LightField> fields(withField ? 1 : 0, LightField{&half});
    EXPECT_TRUE(expectLight(draw(fields, settings), [&](glm::dvec3 p, glm::dvec3 normal) {
      const double cosine = std::abs(glm::dot(normal, glm::normalize(camera_.eye - p)));
      return glm::dvec3(withField ? 0.5 : 0.0) + cosine * glm::dvec3(settings.headLight);
    }));
  }
}

TEST_F(Lights, ColoursChangeWithoutAnUpload) {
  // Another colour of a light needs no upload: the next picture has it, and the first colours give the first picture
  // again, bit for bit.
  const SurfaceField field = fieldOf([](glm::dvec3 p) { return p.x / kSize; });
  const Frame first = draw({{&field}}, settingsWith({{1, 1, 1}}));
  const Frame red = renderer_.render(camera_, settingsWith({{1, 0, 0.5}}));
  EXPECT_TRUE(expectLight(
      red, [&](glm::dvec3 p, glm::dvec3 normal) { return valueAt(field, p, normal) * glm::dvec3(1, 0, 0.5); }));
  const Frame again = renderer_.render(camera_, settingsWith({{1, 1, 1}}));
  ASSERT_EQ(again.color.size(), first.color.size());
  EXPECT_EQ(std::memcmp(again.color.data(), first.color.data(), first.color.size() * sizeof(glm::vec4)), 0);
}

TEST_F(Lights, OneColourForEachField) {
  // Fewer or more colours than fields are an error that tells both numbers; the renderer draws on after it.
  const SurfaceField field = fieldOf([](glm::dvec3) { return 1; });
  upload({{&field}, {&field}});
  for (const std::size_t count : {1, 3}) {
    try {
      renderer_.render(camera_, settingsWith(std::vector<glm::vec3>(count, glm::vec3(1))));
      ADD_FAILURE() << "expected an error for " << count << " colours";
    } catch (const GpuError& error) {
      EXPECT_EQ(std::string(error.what()),
                "render: expected a colour for each of 2 light fields, found " + std::to_string(count));
    }
  }
  EXPECT_EQ(renderer_.render(camera_, settingsWith({})).size, layerSettings().size);
}

}  // namespace
}  // namespace isolume::test
