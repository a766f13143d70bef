#include "ray_points.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "sweep/parallel.h"

namespace isolume {
namespace {

constexpr std::size_t kSigns = 8, kChunk = 1 << 15;

struct LiftedPosition {
  glm::dvec3 perNormal{0};  // lattice points per component of the normal
  glm::dvec3 cell{1};       // of the lattice, world units
  double refinement = 1;
  glm::vec3 low{0}, high{0};

  LiftedPosition(const SolidLattice& lattice, glm::dvec3 spacing)
      : cell(spacing / static_cast<double>(lattice.refinement)), refinement(lattice.refinement) {
    perNormal = 1.0 / cell;
    low = glm::vec3(-kBeyondLattice);
    high = glm::vec3(lattice.size - 1) + kBeyondLattice;
  }
  glm::vec3 operator()(const SurfaceFoot& foot) const {
    const glm::dvec3 normal(foot.normal);
    const double width = glm::dot(glm::abs(normal), cell);
    const glm::dvec3 at = glm::dvec3(foot.position) * refinement + kLift * width * normal * perNormal;
    return glm::clamp(glm::vec3(at), low, high);
  }
};

}  // namespace

RayPoints::RayPoints(std::size_t count)
    : count_(count),
      stride_(count + kRayPadding),
      values_(makeLargeArray<float>(6 * stride_)),
      feet_(makeLargeArray<std::uint32_t>(count)) {
  // What lies beyond the end may be read, and never counts; it must be finite.
  for (int i = 0; i < 6; ++i) std::fill_n(values(i) + count, kRayPadding, 0.0F);
}

void RayPoints::sort(const std::vector<SurfaceFoot>& feet, const SolidLattice& lattice, glm::dvec3 spacing, int axis) {
  const LiftedPosition positionOf(lattice, spacing);
  const RayAxes axes = kRayAxes[static_cast<std::size_t>(axis)];
  const int layers = lattice.size[axis];
  const auto keyOf = [&](glm::vec3 position, glm::vec3 n) {
    const int layer = std::clamp(static_cast<int>(std::floor(position[axis])), -1, layers - 1) + 1;
    return static_cast<std::size_t>(layer) * kSigns + (n.x < 0 ? 1 : 0) + (n.y < 0 ? 2 : 0) + (n.z < 0 ? 4 : 0);
  };
  const std::size_t keys = static_cast<std::size_t>(layers + 1) * kSigns;
  const std::size_t chunks = (feet.size() + kChunk - 1) / kChunk;
  std::vector<std::vector<std::uint32_t>> next(chunks);
  const auto forEach = [&](std::size_t chunk, const auto& visit) {
    const std::size_t end = std::min((chunk + 1) * kChunk, feet.size());
    for (std::size_t i = chunk * kChunk; i < end; ++i) visit(i);
  };
  parallelFor(chunks, [&](std::size_t chunk) {
    next[chunk].assign(keys, 0);
    forEach(chunk, [&](std::size_t i) { ++next[chunk][keyOf(positionOf(feet[i]), feet[i].normal)]; });
  });
  layerBegin_.assign(static_cast<std::size_t>(layers) + 2, feet.size());
  std::uint32_t begin = 0;
  for (std::size_t key = 0; key < keys; ++key) {
    if (key % kSigns == 0) layerBegin_[key / kSigns] = begin;
    for (std::vector<std::uint32_t>& each : next) {
      const std::uint32_t own = each[key];
      each[key] = begin;
      begin += own;
    }
  }
  parallelFor(chunks, [&](std::size_t chunk) {
    forEach(chunk, [&](std::size_t i) {
      const glm::vec3 position = positionOf(feet[i]), normal = feet[i].normal;
      const std::size_t to = next[chunk][keyOf(position, normal)]++;
      values(0)[to] = position[axes.bit];
      values(1)[to] = position[axes.row];
      values(2)[to] = position[axes.layer];
      values(3)[to] = normal[axes.bit];
      values(4)[to] = normal[axes.row];
      values(5)[to] = normal[axes.layer];
      feet_[to] = static_cast<std::uint32_t>(i);
    });
  });
}

}  // namespace isolume
