#include <fmt/format.h>
#include <openvdb/tools/Dense.h>

#include <algorithm>
#include <array>
#include <glm/gtc/type_precision.hpp>
#include <limits>

#include "placement.h"
#include "samples.h"
#include "sweep/parallel.h"
#include "vdb.h"
#include "vdb_archive.h"

namespace isolume {
namespace {

/// Type names of grids as a user reads them; a grid of another type shows OpenVDB's own name and cannot be rendered.
std::string typeName(const openvdb::GridBase& grid) {
  const std::string type = grid.valueType();
  if (grid.isType<openvdb::points::PointDataGrid>()) return "points";
  if (grid.isType<openvdb::MaskGrid>()) return "mask";
  return (type == "float" || type == "double") && grid.saveFloatAsHalf() ? "half" : type;
}

bool isScalar(const openvdb::GridBase& grid) {
  return grid.isType<openvdb::FloatGrid>() || grid.isType<openvdb::DoubleGrid>() || grid.isType<openvdb::Int32Grid>() ||
         grid.isType<openvdb::Int64Grid>() || grid.isType<openvdb::BoolGrid>();
}

std::string kindName(const openvdb::GridBase& grid) {
  switch (grid.getGridClass()) {
    case openvdb::GRID_LEVEL_SET:
      return "level set";
    case openvdb::GRID_FOG_VOLUME:
      return "fog volume";
    case openvdb::GRID_STAGGERED:
      return "staggered";
    default:
      return "unknown";
  }
}

/// Index to world. The Jacobian is taken apart from the translation, so that a far origin costs no digits.
glm::dmat4 worldFromIndex(const std::string& path, const openvdb::GridBase& grid) {
  const openvdb::math::Transform& transform = grid.transform();
  if (!transform.isLinear())
    throw InputError(fmt::format("{}: grid '{}': expected an affine transform, found {} (a frustum)", path,
                                 grid.getName(), transform.mapType()));
  const openvdb::math::MapBase& map = *transform.baseMap();
  glm::dmat4 m(1);
  for (int column = 0; column < 4; ++column) {
    openvdb::Vec3d v(0);
    if (column < 3) v[column] = 1;
    v = column < 3 ? map.applyJacobian(v) : map.applyMap(v);
    m[column] = {v.x(), v.y(), v.z(), column == 3};
  }
  checkPlacement(path, m);
  return m;
}

std::string describeTransform(const openvdb::GridBase& grid) {
  try {
    const glm::dmat4 m = worldFromIndex("", grid);
    std::string text = grid.transform().mapType();
    for (int column = 0; column < 4; ++column)
      text += fmt::format("{}({:.9g}, {:.9g}, {:.9g})",
                          column == 0   ? " "
                          : column == 3 ? " + "
                                        : ", ",
                          m[column].x, m[column].y, m[column].z);
    return text;
  } catch (const InputError&) {
    // The list shows what the file holds, whether or not it can be rendered.
    return std::string(grid.transform().mapType()) + " (not a rotation, reflection and scale)";
  }
}

/// Count and box of the active voxels: from what the writer noted about the grid, else from the grid.
void describeActive(VdbArchive& archive, std::size_t index, VdbGridInfo& info) {
  openvdb::GridBase::Ptr grid = archive.entries()[index].grid;
  const auto low = grid->getMetadata<openvdb::Vec3IMetadata>(openvdb::GridBase::META_FILE_BBOX_MIN);
  const auto high = grid->getMetadata<openvdb::Vec3IMetadata>(openvdb::GridBase::META_FILE_BBOX_MAX);
  const auto count = grid->getMetadata<openvdb::Int64Metadata>(openvdb::GridBase::META_FILE_VOXEL_COUNT);
  openvdb::CoordBBox box;
  if (low && high && count) {
    info.activeCount = static_cast<std::size_t>(count->value());
    box = {openvdb::Coord(low->value()), openvdb::Coord(high->value())};
  } else {
    grid = archive.read(index);
    info.activeCount = grid->activeVoxelCount();
    box = grid->evalActiveVoxelBoundingBox();
  }
  if (info.activeCount == 0 || box.empty()) return;
  info.indexMin = {box.min().x(), box.min().y(), box.min().z()};
  info.indexMax = {box.max().x(), box.max().y(), box.max().z()};
}

std::string listScalars(const VdbArchive& archive) {
  std::vector<std::string> names;
  for (const auto& entry : archive.entries())
    if (isScalar(*entry.grid)) names.push_back(fmt::format("{} ({})", entry.name, typeName(*entry.grid)));
  if (names.empty()) return "no scalar grid";
  return fmt::format("{}", fmt::join(names, ", "));
}

std::size_t chooseGrid(const std::string& path, const VdbArchive& archive, const std::string& wanted) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < archive.entries().size(); ++i) {
    const auto& entry = archive.entries()[i];
    if (wanted.empty() ? isScalar(*entry.grid) : entry.name == wanted || entry.descriptor.gridName() == wanted)
      found.push_back(i);
  }
  // NAME[i] names one grid even where a grid is really called that.
  if (found.size() > 1 && !wanted.empty())
    for (const std::size_t i : found)
      if (archive.entries()[i].name == wanted) return i;
  if (found.size() == 1) {
    const auto& entry = archive.entries()[found[0]];
    if (!isScalar(*entry.grid))
      throw InputError(fmt::format("{}: grid '{}': expected a scalar grid, found {}; scalar: {}", path, entry.name,
                                   typeName(*entry.grid), listScalars(archive)));
    return found[0];
  }
  if (wanted.empty() && found.empty()) {
    std::vector<std::string> all;
    for (const auto& entry : archive.entries()) all.push_back(entry.name + " (" + typeName(*entry.grid) + ")");
    throw InputError(fmt::format("{}: expected a scalar grid, found {}", path,
                                 all.empty() ? "no grid" : fmt::format("{}", fmt::join(all, ", "))));
  }
  if (wanted.empty()) throw InputError(fmt::format("{}: expected --grid, one of: {}", path, listScalars(archive)));
  throw InputError(fmt::format("{}: expected {} grid '{}', found: {}", path, found.empty() ? "a" : "one", wanted,
                               listScalars(archive)));
}

/// Fills the dense grid from the tree, each value by `narrow`, in slabs one leaf thick.
template <class GridT, class Narrow>
WideRange copyDense(const GridT& grid, const openvdb::CoordBBox& box, GridView<float> to, Narrow narrow) {
  using ValueT = typename GridT::ValueType;
  constexpr int kSlab = GridT::TreeType::LeafNodeType::DIM;
  const int firstSlab = box.min().z() >> GridT::TreeType::LeafNodeType::LOG2DIM;
  const int lastSlab = box.max().z() >> GridT::TreeType::LeafNodeType::LOG2DIM;
  std::vector<WideRange> parts(static_cast<std::size_t>(lastSlab - firstSlab + 1));
  parallelFor(parts.size(), [&](std::size_t slab) {
    openvdb::CoordBBox part = box;
    const int z = (firstSlab + static_cast<int>(slab)) * kSlab;
    part.min().z() = std::max(box.min().z(), z);
    part.max().z() = std::min(box.max().z(), z + kSlab - 1);
    float* out = to.data + static_cast<std::size_t>(to.strideZ() * (part.min().z() - box.min().z()));
    if constexpr (std::is_same_v<ValueT, float>) {
      openvdb::tools::Dense<float, openvdb::tools::LayoutXYZ> dense(part, out);
      openvdb::tools::copyToDense(grid.tree(), dense, /*serial=*/true);
    } else {
      openvdb::tools::Dense<ValueT, openvdb::tools::LayoutXYZ> dense(part);
      openvdb::tools::copyToDense(grid.tree(), dense, /*serial=*/true);
      for (std::size_t i = 0; i < dense.valueCount(); ++i) out[i] = narrow(dense.data()[i], parts[slab]);
    }
  });
  WideRange all;
  for (const WideRange& part : parts) all.merge(part);
  return all;
}

template <class GridT>
void fill(const GridT& grid, const openvdb::CoordBBox& box, Volume& volume) {
  using ValueT = typename GridT::ValueType;
  const auto pass = [&](double offset) {
    return copyDense(grid, box, volume.values.view(), [offset](ValueT value, WideRange& seen) {
      if constexpr (std::is_same_v<ValueT, std::int64_t>) {
        return narrowSample(value, offset, seen);
      } else {
        return narrowSample(static_cast<double>(value), offset, seen);
      }
    });
  };
  WideRange seen = pass(0);
  volume.valueOffset = chooseValueOffset(seen, std::is_integral_v<ValueT>);
  if (volume.valueOffset != 0) seen = pass(volume.valueOffset);
  volume.notes = narrowingNotes(seen, volume.sampleType, volume.valueOffset);
}

Volume densify(const std::string& path, const std::string& name, const openvdb::GridBase& grid) {
  const openvdb::CoordBBox active = grid.evalActiveVoxelBoundingBox();
  if (active.empty()) throw InputError(fmt::format("{}: grid '{}': expected active voxels, found none", path, name));
  Volume volume;
  // 64-bit: a box from one end of the index space to the other has more voxels along an axis than an int counts.
  const glm::i64vec3 low{active.min().x(), active.min().y(), active.min().z()};
  const glm::i64vec3 high{active.max().x(), active.max().y(), active.max().z()};
  // Room for the padding and for whole leaves around it.
  constexpr int kMargin = 16;
  if (std::min({low.x, low.y, low.z}) < std::numeric_limits<int>::min() + kMargin ||
      std::max({high.x, high.y, high.z}) > std::numeric_limits<int>::max() - kMargin)
    throw InputError(fmt::format("{}: grid '{}': expected indices well inside 32 bits, found {} {} {} to {} {} {}",
                                 path, name, low.x, low.y, low.z, high.x, high.y, high.z));
  volume.worldFromGrid = worldFromIndex(path, grid);
  const glm::dmat4 world = volume.worldFromGrid;
  volume.worldFromGrid[3] = world * glm::dvec4(glm::dvec3(low - glm::i64vec3(1)), 1);
  volume.values = makeGrid(path, high - low + glm::i64vec3(3), volume.worldFromGrid);
  volume.format = "VDB";
  volume.sampleType = typeName(grid);
  volume.gridName = name;
  volume.files = {path};
  if (grid.getGridClass() == openvdb::GRID_LEVEL_SET) volume.kind = GridKind::levelSet;
  if (grid.getGridClass() == openvdb::GRID_FOG_VOLUME) volume.kind = GridKind::fog;

  openvdb::CoordBBox box = active;
  box.expand(1);
  if (const auto* floats = dynamic_cast<const openvdb::FloatGrid*>(&grid)) fill(*floats, box, volume);
  if (const auto* doubles = dynamic_cast<const openvdb::DoubleGrid*>(&grid)) fill(*doubles, box, volume);
  if (const auto* ints = dynamic_cast<const openvdb::Int32Grid*>(&grid)) fill(*ints, box, volume);
  if (const auto* wide = dynamic_cast<const openvdb::Int64Grid*>(&grid)) fill(*wide, box, volume);
  if (const auto* bools = dynamic_cast<const openvdb::BoolGrid*>(&grid)) fill(*bools, box, volume);
  return volume;
}

}  // namespace

std::vector<VdbGridInfo> listVdbGrids(const std::string& path) {
  return guardVdb(path, [&] {
    VdbArchive archive(path);
    std::vector<VdbGridInfo> infos;
    for (std::size_t i = 0; i < archive.entries().size(); ++i) {
      const auto& entry = archive.entries()[i];
      VdbGridInfo info;
      info.name = entry.name;
      info.type = typeName(*entry.grid);
      info.kind = kindName(*entry.grid);
      info.scalar = isScalar(*entry.grid);
      info.transform = describeTransform(*entry.grid);
      describeActive(archive, i, info);
      infos.push_back(info);
    }
    return infos;
  });
}

Volume readVdb(const std::string& path, const std::string& grid) {
  return guardVdb(path, [&] {
    VdbArchive archive(path);
    const std::size_t index = chooseGrid(path, archive, grid);
    return densify(path, archive.entries()[index].name, *archive.read(index));
  });
}

}  // namespace isolume
