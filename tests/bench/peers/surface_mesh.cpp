#include "tests/bench/peers/surface_mesh.h"

#include <openvdb/openvdb.h>
#include <openvdb/tools/Dense.h>
#include <openvdb/tools/VolumeToMesh.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "raymarch/view.h"
#include "sweep/parallel.h"

namespace isolume::bench {
namespace {

/// The levels with OpenVDB's sign, > 0 outside.
openvdb::FloatGrid::Ptr treeOf(GridView<const float> level) {
  std::vector<float> values(level.count());
  float largest = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    values[i] = -level.data[i];
    largest = std::max(largest, std::abs(values[i]));
  }
  // So steep that the cap of a solid at the border lies within a thousandth of a voxel of the last sample.
  constexpr float kSteep = 1000;
  auto grid = openvdb::FloatGrid::create(kSteep * largest);
  const openvdb::CoordBBox box(openvdb::Coord(0), openvdb::Coord(level.size.x - 1, level.size.y - 1, level.size.z - 1));
  const openvdb::tools::Dense<float, openvdb::tools::LayoutXYZ> dense(box, values.data());
  openvdb::tools::copyFromDense(dense, *grid, 0.0F);
  return grid;
}

/// The trilinear interpolant; outside the box of the samples that of the nearest point inside.
double interpolate(GridView<const float> level, glm::dvec3 p) {
  const glm::ivec3 last = level.size - 1;
  p = glm::clamp(p, glm::dvec3(0), glm::dvec3(last));
  const glm::ivec3 low = glm::min(glm::ivec3(p), last - 1);
  const glm::dvec3 t = p - glm::dvec3(low);
  const auto alongX = [&](int y, int z) {
    return glm::mix(double(level(low.x, low.y + y, low.z + z)), double(level(low.x + 1, low.y + y, low.z + z)), t.x);
  };
  return glm::mix(glm::mix(alongX(0, 0), alongX(1, 0), t.y), glm::mix(alongX(0, 1), alongX(1, 1), t.y), t.z);
}

/// Down the level, so out of the solid; index space, per unit of the spacing.
glm::dvec3 outward(GridView<const float> level, glm::dvec3 p) {
  glm::dvec3 normal(0);
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 before = p, after = p;
    before[axis] = std::max(p[axis] - 1, 0.0);
    after[axis] = std::min(p[axis] + 1, level.size[axis] - 1.0);
    const double length = (after[axis] - before[axis]) * level.spacing[axis];
    if (length > 0) normal[axis] = (interpolate(level, before) - interpolate(level, after)) / length;
  }
  return normal;
}

}  // namespace

SurfaceMesh meshOf(GridView<const float> level, const glm::dmat4& worldFromGrid) {
  openvdb::initialize();
  std::vector<openvdb::Vec3s> points;
  std::vector<openvdb::Vec4I> quads;
  openvdb::tools::volumeToMesh(*treeOf(level), points, quads, 0.0);
  SurfaceMesh mesh;
  mesh.points.resize(points.size());
  mesh.normals.resize(points.size());
  const glm::dmat3 worldFromAxes = makeGridFrame(worldFromGrid).worldFromAxes;
  parallelFor(points.size(), [&](std::size_t i) {
    const glm::dvec3 p(points[i].x(), points[i].y(), points[i].z());
    mesh.points[i] = glm::vec3(worldFromGrid * glm::dvec4(p, 1));
    const glm::dvec3 normal = worldFromAxes * outward(level, p);
    const double length = glm::length(normal);
    mesh.normals[i] = length > 0 ? glm::vec3(normal / length) : glm::vec3(0, 0, 1);
  });
  mesh.triangles.reserve(2 * quads.size());
  for (const openvdb::Vec4I& q : quads) {
    mesh.triangles.push_back({q[0], q[1], q[2]});
    mesh.triangles.push_back({q[0], q[2], q[3]});
  }
  return mesh;
}

}  // namespace isolume::bench
