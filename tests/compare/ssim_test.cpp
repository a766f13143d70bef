// Structural similarity against its definition and its known properties.
#include "src/compare/ssim.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "compare/pictures.h"

namespace isolume::test {
namespace {

constexpr glm::ivec2 kSize{29, 21};
constexpr std::size_t kPixels = 29 * 21;
const std::vector<std::uint8_t> kAll(kPixels, 1);

/// [Wang04] word by word, with the header's mask: two-dimensional windows, means first, then central moments.
std::optional<double> plainSimilarity(glm::ivec2 size, const std::vector<float>& a, const std::vector<float>& b,
                                      const std::vector<std::uint8_t>& mask, double range) {
  const auto index = [&](int x, int y) { return static_cast<std::size_t>(y * size.x + x); };
  double gaussianSum = 0;
  for (int v = -5; v <= 5; ++v)
    for (int u = -5; u <= 5; ++u) gaussianSum += std::exp(-(u * u + v * v) / (2 * 1.5 * 1.5));
  double total = 0;
  int count = 0;
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      if (!mask[index(x, y)]) continue;
      struct Weighted {
        double w, a, b;
      };
      std::vector<Weighted> window;
      double sum = 0;
      for (int v = std::max(0, y - 5); v <= std::min(size.y - 1, y + 5); ++v)
        for (int u = std::max(0, x - 5); u <= std::min(size.x - 1, x + 5); ++u)
          if (mask[index(u, v)]) {
            const double w = std::exp(-((u - x) * (u - x) + (v - y) * (v - y)) / (2 * 1.5 * 1.5)) / gaussianSum;
            window.push_back({w, a[index(u, v)], b[index(u, v)]});
            sum += w;
          }
      if (sum < 0.25) continue;
      double ma = 0, mb = 0, saa = 0, sbb = 0, sab = 0;
      for (const Weighted& p : window) {
        ma += p.w / sum * p.a;
        mb += p.w / sum * p.b;
      }
      for (const Weighted& p : window) {
        saa += p.w / sum * (p.a - ma) * (p.a - ma);
        sbb += p.w / sum * (p.b - mb) * (p.b - mb);
        sab += p.w / sum * (p.a - ma) * (p.b - mb);
      }
      const double c1 = 0.01 * range * 0.01 * range, c2 = 0.03 * range * 0.03 * range;
      total += (2 * ma * mb + c1) * (2 * sab + c2) / ((ma * ma + mb * mb + c1) * (saa + sbb + c2));
      ++count;
    }
  if (count == 0) return std::nullopt;
  return total / count;
}

/// Rounding of sums of 121 products near 1, divided by at least C2 = 9e-4.
constexpr double kRounding = 1e-11;

TEST(Ssim, EqualsItsDefinition) {
  // Noise against noise, with all pixels and with masks of all densities: the separable sums give the plain formula.
  const std::vector<float> a = dyadicNoise(kPixels, 1), noise = dyadicNoise(kPixels, 2);
  std::vector<float> b = a;
  for (std::size_t i = 0; i < kPixels; ++i) b[i] = 0.75f * a[i] + 0.25f * noise[i];
  const std::vector<float> random = dyadicNoise(kPixels, 3);
  for (const float density : {1.0f, 0.9f, 0.5f, 0.3f}) {
    std::vector<std::uint8_t> mask(kPixels);
    for (std::size_t i = 0; i < kPixels; ++i) mask[i] = random[i] < density;
    for (const double range : {1.0, 2.0}) {
      const std::optional<double> got = structuralSimilarity(kSize, a, b, mask, range);
      const std::optional<double> want = plainSimilarity(kSize, a, b, mask, range);
      ASSERT_TRUE(got && want);
      EXPECT_NEAR(*got, *want, kRounding) << density;
      EXPECT_LT(*got, 0.99);  // so that the agreement says something
    }
  }
}

TEST(Ssim, IsOneForTheSameAndSymmetric) {
  // Identical pictures: exactly 1. Exchanged pictures: the same bits.
  const std::vector<float> a = dyadicNoise(kPixels, 4), b = dyadicNoise(kPixels, 5);
  EXPECT_EQ(structuralSimilarity(kSize, a, a, kAll, 1), 1.0);
  EXPECT_EQ(structuralSimilarity(kSize, a, b, kAll, 1), structuralSimilarity(kSize, b, a, kAll, 1));
}

TEST(Ssim, ConstantPicturesGiveTheLuminanceTerm) {
  // Two constants p and q: (2 p q + C1) / (p^2 + q^2 + C1), since all variances are 0.
  const float p = 0.5f, q = 0.75f;
  const double c1 = 0.01 * 0.01;
  const std::optional<double> ssim =
      structuralSimilarity(kSize, std::vector<float>(kPixels, p), std::vector<float>(kPixels, q), kAll, 1);
  ASSERT_TRUE(ssim);
  EXPECT_NEAR(*ssim, (2.0 * p * q + c1) / (p * p + q * q + c1), kRounding);
}

TEST(Ssim, ConstantShiftLeavesStructure) {
  // Stripes of period 2 columns, which the window averages to known moments, shifted by s: only luminance falls.
  std::vector<float> a(kPixels), b(kPixels);
  for (std::size_t i = 0; i < kPixels; ++i) {
    a[i] = i % 29 % 2 ? 0.25f : 0.5f;
    b[i] = a[i] + 0.25f;
  }
  double want = 0;  // per pixel, from its own window's mean m: (2 m (m + s) + C1) / (m^2 + (m + s)^2 + C1)
  for (int y = 0; y < kSize.y; ++y)
    for (int x = 0; x < kSize.x; ++x) {
      double sum = 0, mean = 0;
      for (int u = std::max(0, x - 5); u <= std::min(kSize.x - 1, x + 5); ++u) {
        const double w = std::exp(-(u - x) * (u - x) / (2 * 1.5 * 1.5));
        sum += w;
        mean += w * a[static_cast<std::size_t>(u)];
      }
      mean /= sum;
      want += (2 * mean * (mean + 0.25) + 1e-4) / (mean * mean + (mean + 0.25) * (mean + 0.25) + 1e-4);
    }
  EXPECT_NEAR(*structuralSimilarity(kSize, a, b, kAll, 1), want / kPixels, kRounding);
}

TEST(Ssim, OnePixelShiftOfNoiseDestroysIt) {
  // Independent noise shifted by one pixel has no structure in common: similarity near 0, not near 1.
  const std::vector<float> a = dyadicNoise(kPixels, 6);
  std::vector<float> b = a;
  std::rotate(b.begin(), b.begin() + 1, b.end());
  // The luminance term is nearly 1; a window of about 1 / sum w^2 = 28 pixels has a correlation of 0 +- 1 / sqrt(28),
  // the mean over about 600 / 28 of them 0 +- .04. Four times that.
  EXPECT_NEAR(*structuralSimilarity(kSize, a, b, kAll, 1), 0, 0.16);
}

TEST(Ssim, MaskedPixelsDoNotMatter) {
  // Whatever stands outside the mask, NaN too, changes no bit.
  const std::vector<float> a = dyadicNoise(kPixels, 7), b = dyadicNoise(kPixels, 8);
  std::vector<std::uint8_t> mask = kAll;
  std::vector<float> c = b;
  for (std::size_t i = 0; i < kPixels; i += 3) {
    mask[i] = 0;
    c[i] = kNan;
  }
  EXPECT_EQ(structuralSimilarity(kSize, a, b, mask, 1), structuralSimilarity(kSize, a, c, mask, 1));
  EXPECT_TRUE(std::isfinite(*structuralSimilarity(kSize, a, c, mask, 1)));
}

TEST(Ssim, LonePixelsSayNothing) {
  // A window with less than a quarter of the weight is left out: lone pixels give none, an upright thread gives one.
  std::vector<std::uint8_t> lone(kPixels), thread(kPixels);
  for (int y = 0; y < kSize.y; ++y) thread[static_cast<std::size_t>(y * kSize.x + 14)] = 1;
  for (int y = 0; y < kSize.y; y += 7)
    for (int x = 0; x < kSize.x; x += 7) lone[static_cast<std::size_t>(y * kSize.x + x)] = 1;
  const std::vector<float> a = dyadicNoise(kPixels, 9);
  EXPECT_FALSE(structuralSimilarity(kSize, a, a, lone, 1));
  EXPECT_EQ(structuralSimilarity(kSize, a, a, thread, 1), 1.0);
  EXPECT_FALSE(structuralSimilarity(kSize, a, a, std::vector<std::uint8_t>(kPixels), 1));
}

TEST(Ssim, RangeFollowsTheLayer) {
  // Openness is compared with L = 1, normals with L = 2, depth with the range of WANT: the last does not change with
  // units.
  Image a = noisePicture(kSize, 10), b = noisePicture(kSize, 11);
  const std::vector<float> x = channelOf(a, "ambient.Y"), y = channelOf(b, "ambient.Y");
  EXPECT_EQ(compare(a, b).ssim, structuralSimilarity(kSize, x, y, kAll, 1));
  Image na = picture(kSize, x, "normal.Y"), nb = picture(kSize, y, "normal.Y");
  for (Image* image : {&na, &nb})
    for (const char* other : {"normal.X", "normal.Z"}) image->channels.push_back({other, x});
  EXPECT_EQ(compare(na, nb, "normal.Y").ssim, structuralSimilarity(kSize, x, y, kAll, 2));
  for (const float unit : {1.0f, 1024.0f}) {
    for (std::size_t i = 0; i < kPixels; ++i) {
      channelOf(a, "Z")[i] = unit * x[i];
      channelOf(b, "Z")[i] = unit * y[i];
    }
    const auto [low, high] = std::minmax_element(y.begin(), y.end());
    EXPECT_NEAR(*compare(a, b, "Z").ssim, *structuralSimilarity(kSize, x, y, kAll, *high - *low), kRounding);
  }
}

}  // namespace
}  // namespace isolume::test
