#include "sweep/octants/geometry_terms.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <vector>

namespace isolume {
namespace {

// 200 directions spread evenly over the sphere (Fibonacci lattice), and the axes and diagonals, where G has its kinks.
std::vector<glm::dvec3> testNormals() {
  std::vector<glm::dvec3> normals;
  for (int i = 0; i < 200; ++i) {
    const double z = 1 - 2 * (i + 0.5) / 200;
    const double angle = i * std::numbers::pi * (3 - std::sqrt(5.0));
    const double r = std::sqrt(1 - z * z);
    normals.emplace_back(r * std::cos(angle), r * std::sin(angle), z);
  }
  for (int x = -1; x <= 1; ++x)
    for (int y = -1; y <= 1; ++y)
      for (int z = -1; z <= 1; ++z)
        if (x != 0 || y != 0 || z != 0) normals.push_back(glm::normalize(glm::dvec3(x, y, z)));
  return normals;
}

// Midpoint rule in (cos theta, phi) over one octant.
double integrated(int octant, glm::dvec3 normal, GeometryTerm term, int steps) {
  const glm::ivec3 sign = kOctants[static_cast<std::size_t>(octant)].towardsLight();
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double z = (i + 0.5) / steps;
    const double r = std::sqrt(1 - z * z);
    for (int j = 0; j < steps; ++j) {
      const double phi = (j + 0.5) / steps * std::numbers::pi / 2;
      const glm::dvec3 direction(sign.x * r * std::cos(phi), sign.y * r * std::sin(phi), sign.z * z);
      const double cosine = glm::dot(normal, direction);
      sum += term == GeometryTerm::front ? std::max(cosine, 0.0) : std::abs(cosine);
    }
  }
  return sum / (static_cast<double>(steps) * steps) * std::numbers::pi / 2;
}

TEST(GeometryTerms, EqualTheirIntegral) {
  // G_s(N) equals the numerical integral over octant s of max(N . w, 0), or of |N . w|.
  constexpr int kSteps = 400;  // the midpoint rule is then good to about 1e-5
  constexpr double kBound = 1e-4;
  const std::vector<glm::dvec3> normals = testNormals();
  for (std::size_t i = 0; i < normals.size(); i += 7) {
    for (int s = 0; s < kOctantCount; ++s)
      for (const GeometryTerm term : {GeometryTerm::front, GeometryTerm::bothSides})
        EXPECT_NEAR(octantGeometryTerm(s, normals[i], term), integrated(s, normals[i], term, kSteps), kBound);
  }
}

TEST(GeometryTerms, SumToPi) {
  // The clamped cosine integrates to pi over the sphere, whatever the normal, and its magnitude to twice that.
  for (const glm::dvec3& normal : testNormals())
    for (const GeometryTerm term : {GeometryTerm::front, GeometryTerm::bothSides}) {
      double sum = 0;
      for (int s = 0; s < kOctantCount; ++s) sum += octantGeometryTerm(s, normal, term);
      EXPECT_NEAR(sum, (term == GeometryTerm::front ? 1 : 2) * std::numbers::pi, 1e-12);
    }
}

TEST(GeometryTerms, OfBothSidesDoNotTellThemApart) {
  // |N . w| is that of -N, and an octant counts as much as the one opposite.
  for (const glm::dvec3& normal : testNormals())
    for (int s = 0; s < kOctantCount; ++s) {
      const double term = octantGeometryTerm(s, normal, GeometryTerm::bothSides);
      EXPECT_EQ(octantGeometryTerm(s, -normal, GeometryTerm::bothSides), term);
      EXPECT_NEAR(octantGeometryTerm(7 - s, normal, GeometryTerm::bothSides), term, 1e-14);
    }
}

TEST(GeometryTerms, KnownValues) {
  // An octant right above an axis normal gets a quarter of pi; the octant around a diagonal normal sqrt(3) pi / 4.
  EXPECT_NEAR(octantGeometryTerm(7, {0, 0, 1}), std::numbers::pi / 4, 1e-15);
  EXPECT_NEAR(octantGeometryTerm(0, {0, 0, 1}), 0, 1e-15);
  EXPECT_NEAR(octantGeometryTerm(7, glm::normalize(glm::dvec3(1))), std::sqrt(3.0) * std::numbers::pi / 4, 1e-14);
}

// What the shader does with the tables, in double.
glm::dvec4 lookUp(const GeometryTermTables& tables, int table, glm::dvec3 normal) {
  const glm::dvec2 r = glm::dvec2(normal) / std::sqrt(1 + std::abs(normal.z));
  const glm::dvec2 coordinate = (r * ((tables.size - 1.0) / tables.size) + 1.0) * 0.5;
  const auto& texels = tables.texels[static_cast<std::size_t>(table)];
  const glm::dvec2 position = coordinate * static_cast<double>(tables.size) - 0.5;
  const glm::dvec2 corner = glm::floor(position);
  const glm::dvec2 f = position - corner;
  const auto texel = [&](double x, double y) {
    const auto clampedX = static_cast<std::size_t>(std::clamp(x, 0.0, tables.size - 1.0));
    const auto clampedY = static_cast<std::size_t>(std::clamp(y, 0.0, tables.size - 1.0));
    return glm::dvec4(texels[clampedY * static_cast<std::size_t>(tables.size) + clampedX]);
  };
  return glm::mix(glm::mix(texel(corner.x, corner.y), texel(corner.x + 1, corner.y), f.x),
                  glm::mix(texel(corner.x, corner.y + 1), texel(corner.x + 1, corner.y + 1), f.x), f.y);
}

TEST(GeometryTermTables, InterpolatedLookupEqualsTheClosedForm) {
  // Bilinear lookup at any normal, mirrored for N.z < 0, is within 1e-4 of G_s(N), the horizon of the table included.
  for (const GeometryTerm term : {GeometryTerm::front, GeometryTerm::bothSides}) {
    const GeometryTermTables tables = makeGeometryTermTables(kGeometryTableSize, term);
    double worst = 0;
    for (const glm::dvec3& normal : testNormals()) {
      const bool down = normal.z < 0;
      for (int s = 0; s < kOctantCount; ++s) {
        const double got = lookUp(tables, down ? 1 - s / 4 : s / 4, normal)[s % 4];
        worst = std::max(worst, std::abs(got - octantGeometryTerm(s, normal, term)));
      }
    }
    EXPECT_LT(worst, 1e-4);
  }
}

TEST(GeometryTermTables, CoarseTablesAreWorse) {
  // The bound of the test above can fail: a table an eighth as wide misses it.
  const GeometryTermTables tables = makeGeometryTermTables(16);
  double worst = 0;
  for (const glm::dvec3& normal : testNormals()) {
    if (normal.z < 0) continue;
    for (int s = 0; s < kOctantCount; ++s) {
      worst = std::max(worst, std::abs(lookUp(tables, s / 4, normal)[s % 4] - octantGeometryTerm(s, normal)));
    }
  }
  EXPECT_GT(worst, 1e-4);
}

}  // namespace
}  // namespace isolume
