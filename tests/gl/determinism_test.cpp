#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "gl/gl_scene.h"

namespace isolume::test {
namespace {

Frame picture() {
  const GlScene scene = makeSphere();
  RenderSettings settings = layerSettings();
  settings.samples = 3;
  settings.shading = Shading::octants;
  return renderOnce(scene, frameScene(scene), settings);
}

template <class T>
bool sameBits(const std::vector<T>& a, const std::vector<T>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

// FNV-1a over all layers.
std::uint64_t fingerprint(const Frame& frame) {
  std::uint64_t hash = 14695981039346656037ull;
  const auto add = [&hash](const auto& values) {
    const auto* bytes = reinterpret_cast<const unsigned char*>(values.data());
    for (std::size_t i = 0; i < values.size() * sizeof(values[0]); ++i) hash = (hash ^ bytes[i]) * 1099511628211ull;
  };
  add(frame.color);
  add(frame.normal);
  add(frame.position);
  add(frame.depth);
  return hash;
}

TEST(Determinism, TwoRendersAreBitwiseEqual) {
  // Same scene, camera and settings: same bits, also from a second context, and with other pictures between.
  const GlScene scene = makeSphere();
  const Camera camera = frameScene(scene);
  const auto context = makeContext("osmesa");
  Renderer renderer(*context);
  renderer.upload(scene.fields());
  const Frame first = renderer.render(camera, layerSettings());
  RenderSettings other = layerSettings(31, 200);
  other.samples = 2;
  renderer.render(camera, other);
  renderer.upload(makeSphere(30, 4).fields());
  renderer.upload(scene.fields());
  const Frame second = renderer.render(camera, layerSettings());
  EXPECT_TRUE(sameBits(first.color, second.color));
  EXPECT_TRUE(sameBits(first.normal, second.normal));
  EXPECT_TRUE(sameBits(first.position, second.position));
  EXPECT_TRUE(sameBits(first.depth, second.depth));
  EXPECT_EQ(fingerprint(picture()), fingerprint(picture()));
}

// Run by the next test in processes of its own, with the number of rasteriser threads in the environment.
TEST(Determinism, DISABLED_PrintFingerprint) {
  // Prints what another process compares.
  const Frame frame = picture();
  ASSERT_FALSE(frame.color.empty());
  std::printf("fingerprint %016llx\n", static_cast<unsigned long long>(fingerprint(frame)));
}

std::string fingerprintWithThreads(int threads) {
  char self[4096] = {};
  if (readlink("/proc/self/exe", self, sizeof(self) - 1) <= 0) return "no /proc";
  const std::string command = "LP_NUM_THREADS=" + std::to_string(threads) + " '" + self +
                              "' --gtest_also_run_disabled_tests --gtest_filter=Determinism.DISABLED_PrintFingerprint";
  FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) return "no process";
  std::string found;
  char line[512];
  while (std::fgets(line, sizeof(line), pipe)) {
    if (std::strncmp(line, "fingerprint ", 12) == 0) found = line;
  }
  return pclose(pipe) == 0 ? found : "failed";
}

TEST(Determinism, RasteriserThreadsDoNotMatter) {
  // 0, 1, 2 and 5 threads of the software rasteriser give the same bits in every layer.
  const std::string one = fingerprintWithThreads(1);
  ASSERT_EQ(one.substr(0, 12), "fingerprint ");
  for (const int threads : {0, 2, 5}) EXPECT_EQ(fingerprintWithThreads(threads), one) << threads;
}

}  // namespace
}  // namespace isolume::test
