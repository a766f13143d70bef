// Openness against an independent tracer on a mesh of the same volume.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "estimators/closed_form.h"
#include "src/io/volume.h"
#include "support/cpu_tracer.h"
#include "support/embree_scene.h"
#include "support/shared_data.h"
#include "support/tetra_mesh.h"
#include "sweep/level.h"
#include "sweep/reference/directions.h"
#include "sweep/reference/low_discrepancy.h"
#include "volumes/scenes.h"

namespace isolume::test {
namespace {

constexpr int kRays = 512;
/// Triangles of the trilinear interpolant, sampled `refine` times as finely along each axis: a mesh of the samples
/// themselves is farther from the isosurface than openness forgives. The interpolant is that of support/cpu_tracer.h.
std::vector<glm::vec3> fineMesh(GridView<const float> level, int refine) {
  const Grid<float> fine = sampleLevel((level.size - 1) * refine + 1, glm::dvec3(1.0 / refine),
                                       [level](glm::dvec3 p) { return levelAt(level, p); });
  std::vector<glm::vec3> triangles = tetraMesh(fine.view());
  for (glm::vec3& corner : triangles) corner /= static_cast<float>(refine);
  return triangles;
}

/// Parallel rays from a corner of the box, so that many kinds of surface points are seen.
std::vector<ReferencePixel> obliquePixels(const ReferenceScene& scene, int side) {
  const glm::dvec3 size(scene.tracer.level().size - 1), direction = glm::normalize(glm::dvec3(0.5, 0.6, -0.8));
  const glm::dmat3 frame = frameAbout(direction);
  PixelRays rays;
  rays.size = glm::ivec2(side);
  rays.origin = 0.5 * size - 2 * glm::length(size) * direction;
  rays.originX = frame[0] * (glm::length(size) / side);
  rays.originY = frame[1] * (glm::length(size) / side);
  rays.direction = direction;
  return traceReference(scene, rays, {{0, 0}, {side, side}}, {}, {.rays = kRays});
}

/// Rays start that many voxels above the mesh: triangles have no memory of where a ray came from. A hundred times the
/// rounding of Embree's floats at these coordinates.
constexpr double kLift = 5e-4;

/// Farther off than that the mesh is another solid: tetrahedra cut off the outer edges of boxes, half of a cell deep.
constexpr double kFarthest = 0.01;

/// Where the mesh lies under a point of the isosurface, along its normal, if not too far off.
std::optional<glm::dvec3> onMesh(const EmbreeScene& mesh, const ShadedPoint& point) {
  const glm::dvec3 above = point.hit.position + kFarthest * point.normal;
  const auto met = mesh.firstHit({above, -point.normal, 0, 2 * kFarthest});
  if (!met) return std::nullopt;
  return above - *met * point.normal;
}

/// Openness of a point by the mesh, from `lift` above it. The key decides on the directions.
ChannelEstimate meshOpenness(const EmbreeScene& mesh, glm::dvec3 position, glm::dvec3 normal, double lift,
                             std::uint64_t key) {
  std::array<Channels, kReplicates> sums{};
  const glm::dmat3 frame = frameAbout(normal);
  const glm::dvec3 origin = position + lift * normal;
  for (int replicate = 0; replicate < kReplicates; ++replicate)
    for (int i = 0; i < kRays / kReplicates; ++i) {
      const glm::dvec2 u =
          scrambledSobol(mixKey(key, static_cast<std::uint64_t>(replicate)), 0, static_cast<std::uint32_t>(i));
      const GridRay ray{origin, frame * cosineDirection(u)};
      sums[replicate][0] += mesh.isBlocked(ray) ? 0 : 1;
    }
  return estimateOf(sums, kRays / kReplicates, [](const Channels& mean) { return mean; });
}

struct Agreement {
  int points = 0, offMesh = 0;
  double within = 0;  ///< share of points that differ by at most two standard errors and the mesh's own error
  double bias = 0;    ///< mean of mesh - ours
};

/// The mesh's own error at a point: how much its openness changes, with the same directions, from twice the lift.
Agreement compare(const TestScene& scene, int refine) {
  constexpr int kSide = 64;  // pixels
  const EmbreeScene mesh(fineMesh(scene.level.view(), refine));
  Agreement agreement;
  std::uint64_t stream = 0;
  for (const ReferencePixel& pixel : obliquePixels(scene.scene(), kSide)) {
    if (!pixel.hit) continue;
    const std::optional<glm::dvec3> position = onMesh(mesh, pixel.point);
    if (!position) {
      ++agreement.offMesh;
      continue;
    }
    const std::uint64_t key = mixBits(++stream);
    const glm::dvec3 normal = pixel.point.normal;
    const ChannelEstimate ours = pixel.estimate.channels, theirs = meshOpenness(mesh, *position, normal, kLift, key);
    const double lifted = meshOpenness(mesh, *position, normal, 2 * kLift, key).value[0];
    const double difference = theirs.value[0] - ours.value[0], meshError = std::abs(lifted - theirs.value[0]);
    const double error = std::hypot(ours.standardError[0], theirs.standardError[0]);
    ++agreement.points;
    if (std::abs(difference) <= 2 * error + meshError) ++agreement.within;
    agreement.bias += difference;
  }
  agreement.within /= agreement.points;
  agreement.bias /= agreement.points;
  return agreement;
}

/// Of two standard errors, with 30 degrees of freedom together, 94.5 % of the points; a share of a few hundred scatters
/// by 2 %. The noise of the bias is .015 over the root of their number, .001 at most.
void expectAgreement(const TestScene& scene, int refine) {
  const Agreement got = compare(scene, refine);
  EXPECT_GT(got.points, 200);
  EXPECT_LT(got.offMesh, 0.06 * got.points);  // edges of the gyroid's cut
  EXPECT_GT(got.within, 0.92);
  EXPECT_NEAR(got.bias, 0, 1.5e-3);
}

TEST(AgainstEmbree, Boxes) {
  // Agrees with the mesh: a floor, a wall, a box and a slab: concave and convex edges, penumbras of all widths.
  const TestScene scene(glm::ivec3(33), glm::dvec3(1), [](glm::dvec3 p) {
    const double box = std::min({p.x - 12, 22 - p.x, p.y - 10, 20 - p.y, 14 - p.z});
    const double slab = std::min({p.x - 8, p.z - 20, 24 - p.z});
    return std::max({floorLevel(p, 4), p.x - 28, box, slab});
  });
  expectAgreement(scene, 4);
}

TEST(AgainstEmbree, SphereOnAFloor) {
  // Agrees with the mesh: a curved surface that hangs over a flat one.
  const TestScene scene(glm::ivec3(49), glm::dvec3(1), [](glm::dvec3 p) {
    return std::max(floorLevel(p, 4), 12 - glm::length(p - glm::dvec3(24, 24, 20)));
  });
  expectAgreement(scene, 3);
}

TEST(AgainstEmbree, Gyroid) {
  // Agrees with the mesh: a sheet with openings behind openings: half of the light is lost.
  const Scene& gyroid = *findScene("gyroid");
  const TestScene scene(glm::ivec3(64), glm::dvec3(1),
                        [&gyroid](glm::dvec3 p) { return -gyroid.value((p + 0.5) / 64.0); });
  expectAgreement(scene, 3);
}

TEST(AgainstEmbree, BenzeneOrbital) {
  // Agrees with the mesh: real data, with few samples across a lobe.
  ISOLUME_NEED_SHARED(path, "benzene_homo.mhd");
  Volume volume = readVolume(path, {});
  makeLevel(volume.values.view(), 0.03f, Inside::above);
  const GridView<const float> values = volume.values.view();
  const TestScene scene(values.size, glm::dvec3(1), [&values](glm::dvec3 p) {
    return values(static_cast<int>(p.x), static_cast<int>(p.y), static_cast<int>(p.z));
  });
  expectAgreement(scene, 3);
}

}  // namespace
}  // namespace isolume::test
