#include "ray_points.h"

#include <algorithm>
#include <cmath>

#include "sweep/parallel.h"

namespace isolume {
namespace {

// Facing all rays of one sense, mixed, facing all of the other. Mixed ones by their normals: how much of them is along
// the layers' axis, and where the rest points, by thirds of quarters.
constexpr std::size_t kTilts = 4, kTurns = 12, kKinds = 2 + kTilts * kTurns;

// `cell` and the normal in the order of the axes. From layer to layer a ray moves by one point at most along either of
// the other axes: where the normal's part along the layers outweighs the other two, all rays of a sense are on one
// side.
std::size_t kindOf(glm::vec3 normal, glm::vec3 cell) {
  const glm::vec3 across = normal * cell;
  const float x = std::abs(across.x), y = std::abs(across.y), most = x + y;
  if (!(std::abs(across.z) < most)) return across.z > 0 ? 0 : kKinds - 1;
  const auto tilt = static_cast<std::size_t>((1 - across.z / most) * (kTilts / 2));
  // Counter-clockwise from +x, so that neighbours in the order are neighbours on the circle.
  const bool turned = (across.x < 0) != (across.y < 0);
  const float along = turned ? x : y;
  const std::size_t third = along * 3 < most ? 0 : along * 3 < 2 * most ? 1 : 2;
  const std::size_t quarter = across.y < 0 ? (across.x < 0 ? 2 : 3) : (across.x < 0 ? 1 : 0);
  return 1 + std::min(tilt, kTilts - 1) * kTurns + quarter * 3 + third;
}

// Along y (axis 1) or z (2), from the first with a solid point to the last.
RowRange solidRows(const SolidLattice& lattice, int axis) {
  const BitRows& bits = lattice.alongX;
  const auto anyIn = [&](int row) {
    const int first = axis == 2 ? row : 0, last = axis == 2 ? row : bits.layers - 1;
    for (int z = first; z <= last; ++z) {
      const std::uint64_t* begin = bits.row(axis == 2 ? 0 : row, z);
      const std::ptrdiff_t words = static_cast<std::ptrdiff_t>(axis == 2 ? bits.rows : 1) * bits.words;
      if (std::any_of(begin, begin + words, [](std::uint64_t word) { return word != 0; })) return true;
    }
    return false;
  };
  RowRange rows{0, lattice.size[axis]};
  while (!rows.empty() && !anyIn(rows.begin)) ++rows.begin;
  while (!rows.empty() && !anyIn(rows.end - 1)) --rows.end;
  return rows;
}

}  // namespace

RayPoints::RayPoints(std::size_t count)
    : count_(count),
      stride_(count + kRayPadding),
      values_(makeLargeArray<float>(6 * stride_)),
      feet_(makeLargeArray<std::uint32_t>(count)) {
  // What lies beyond the end may be read, and never counts; it must be finite.
  for (int i = 0; i < 6; ++i) std::fill_n(values(i) + count, kRayPadding, 0.0F);
}

void RayPoints::sort(const FootChunks& feet, const SolidLattice& lattice, glm::dvec3 spacing, int axis) {
  const RayAxes axes = kRayAxes[static_cast<std::size_t>(axis)];
  const int layers = lattice.size[axis];
  const auto ordered = [axes](glm::vec3 v) { return glm::vec3(v[axes.bit], v[axes.row], v[axes.layer]); };
  const glm::vec3 cell = ordered(glm::vec3(spacing));
  const auto scale = static_cast<float>(lattice.refinement);
  const auto keyOf = [&](const SurfaceFoot& foot) {
    const int layer = std::clamp(static_cast<int>(foot.position[axis] * scale), 0, layers - 1);
    return static_cast<std::size_t>(layer) * kKinds + kindOf(ordered(foot.normal), cell);
  };
  const std::size_t keys = static_cast<std::size_t>(layers) * kKinds;
  std::vector<std::vector<std::uint32_t>> next(feet.chunks());
  const auto keyOfFoot = makeLargeArray<std::uint32_t>(feet.count());
  // visit(i, foot) for each of a chunk.
  const auto forEach = [&](std::size_t chunk, const auto& visit) {
    std::vector<SurfaceFoot> room;
    const SurfaceFoot* foot = feet.feet(chunk, room);
    for (std::size_t i = feet.begin[chunk]; i < feet.begin[chunk + 1]; ++i) visit(i, *foot++);
  };
  parallelFor(feet.chunks(), [&](std::size_t chunk) {
    next[chunk].assign(keys, 0);
    forEach(chunk, [&](std::size_t i, const SurfaceFoot& foot) {
      keyOfFoot[i] = static_cast<std::uint32_t>(keyOf(foot));
      ++next[chunk][keyOfFoot[i]];
    });
  });
  layerBegin_.assign(static_cast<std::size_t>(layers) + 1, feet.count());
  std::uint32_t begin = 0;
  for (std::size_t key = 0; key < keys; ++key) {
    if (key % kKinds == 0) layerBegin_[key / kKinds] = begin;
    for (std::vector<std::uint32_t>& each : next) {
      const std::uint32_t own = each[key];
      each[key] = begin;
      begin += own;
    }
  }
  std::vector<RowRange> rows(feet.chunks());
  parallelFor(feet.chunks(), [&](std::size_t chunk) {
    forEach(chunk, [&](std::size_t i, const SurfaceFoot& foot) {
      const std::size_t to = next[chunk][keyOfFoot[i]]++;
      const glm::vec3 position = ordered(foot.position * scale), normal = ordered(foot.normal);
      for (int k = 0; k < 3; ++k) {
        values(k)[to] = position[k];
        values(3 + k)[to] = normal[k];
      }
      feet_[to] = static_cast<std::uint32_t>(i);
      const int row = static_cast<int>(std::floor(position.y));
      rows[chunk] = unionOf(rows[chunk], {row, row + 1});
    });
  });
  RowRange stoodIn;
  for (const RowRange& each : rows) stoodIn = unionOf(stoodIn, each);
  const RowRange all{0, lattice.size[axes.row]};
  rowsRead_ =
      unionOf(solidRows(lattice, axes.row), sharedBy({stoodIn.begin - kMostRowsOff, stoodIn.end + kMostRowsOff}, all));
}

}  // namespace isolume
