#include "raymarch/context.h"

#include <glad/gl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "gl/gl_scene.h"
#include "raymarch/gpu_error.h"
#include "raymarch/program.h"
#include "raymarch/program_variants.h"

namespace isolume {
namespace {

using ::testing::HasSubstr;

// The context, or nullptr with the reason printed where a backend cannot exist on this machine.
std::unique_ptr<Context> tryContext(std::string_view name, std::string& reason) {
  try {
    return makeContext(name);
  } catch (const GpuError& error) {
    reason = error.what();
    return nullptr;
  }
}

class BackendTest : public ::testing::TestWithParam<std::string_view> {};

TEST_P(BackendTest, ComesAndGoesWithoutErrors) {
  // A context can be made, used and destroyed again and again, offers OpenGL 4.5 core and raises no GL error.
  for (int round = 0; round < 3; ++round) {
    std::string reason;
    const auto context = tryContext(GetParam(), reason);
    if (!context) GTEST_SKIP() << reason;
    EXPECT_EQ(context->backend(), GetParam());
    EXPECT_THAT(context->description(), HasSubstr("4."));
    GLint mask = 0;
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &mask);
    EXPECT_EQ(mask & GL_CONTEXT_CORE_PROFILE_BIT, GL_CONTEXT_CORE_PROFILE_BIT);
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR));
  }
}

TEST_P(BackendTest, EveryProgramVariantCompiles) {
  // Each program of the table builds on each backend.
  std::string reason;
  const auto context = tryContext(GetParam(), reason);
  if (!context) GTEST_SKIP() << reason;
  ASSERT_FALSE(programVariants().empty());
  for (const ProgramVariant& variant : programVariants()) {
    EXPECT_TRUE(buildProgram(variant.vertex, variant.fragment)) << variant.name;
  }
}

INSTANTIATE_TEST_SUITE_P(AllBackends, BackendTest, ::testing::ValuesIn(backendNames()),
                         [](const auto& parameter) { return std::string(parameter.param); });

TEST(Context, UnknownBackendIsAnErrorThatListsTheKnownOnes) {
  // A misspelt name is never replaced by another backend.
  try {
    makeContext("vulkan");
    FAIL() << "no error";
  } catch (const GpuError& error) {
    EXPECT_STREQ(error.what(), "backend: expected one of auto, egl, osmesa, found vulkan");
  }
}

TEST(Context, OsmesaAndAutoWorkHere) {
  // The software backend is what the other tests draw with, so its absence is a failure and not a skip.
  EXPECT_EQ(makeContext("osmesa")->backend(), "osmesa");
  EXPECT_THAT(backendNames(), ::testing::Contains(makeContext("auto")->backend()));
}

TEST(Context, BackendsAlternateInOneProcess) {
  // A renderer on one backend after a renderer on the other draws the same surface: the GL functions are those of the
  // current context. (Positions, since two drivers may round differently.)
  const test::GlScene scene = test::makeSphere();
  const Camera camera = test::frameScene(scene);
  const Frame before = test::renderOnce(scene, camera, test::layerSettings());
  std::string reason;
  auto context = tryContext("egl", reason);
  if (!context) GTEST_SKIP() << reason;
  Frame other;
  {
    Renderer renderer(*context);
    renderer.upload(scene.fields());
    other = renderer.render(camera, test::layerSettings());
  }
  context.reset();
  const Frame after = test::renderOnce(scene, camera, test::layerSettings());
  EXPECT_EQ(before.color, after.color);
  int differing = 0;
  for (std::size_t i = 0; i < before.depth.size(); ++i)
    differing += !(std::abs(before.depth[i] - other.depth[i]) < 1e-3f) && before.depth[i] != other.depth[i];
  // Of 120 x 96 pixels, those whose ray grazes the sphere may go either way.
  EXPECT_LE(differing, 4);
}

}  // namespace
}  // namespace isolume
