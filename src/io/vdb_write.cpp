#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <memory>

#include "errors.h"
#include "sweep/parallel.h"
#include "vdb.h"
#include "vdb_archive.h"
#include "vdb_dense.h"

namespace isolume {
namespace {

using Leaf = openvdb::FloatTree::LeafNodeType;
constexpr int kLeaf = Leaf::DIM;

/// One 8^3 block of a dense grid: a leaf, or one value for all of it.
struct Block {
  openvdb::Coord origin;
  std::unique_ptr<Leaf> leaf;
  float value = 0;
  bool active = false;
};

template <class Fill>
openvdb::FloatGrid::Ptr build(GridView<const float> values, const glm::dmat4& worldFromGrid, const std::string& name,
                              float background, Fill fillBlock) {
  initializeVdb();
  const glm::ivec3 blocks = (values.size + kLeaf - 1) / kLeaf;
  std::vector<Block> made(voxelCount(blocks));
  parallelFor(made.size(), [&](std::size_t i) {
    const auto index = static_cast<std::int64_t>(i);
    const std::int64_t row = index / blocks.x;
    made[i].origin = openvdb::Coord(kLeaf * static_cast<int>(index % blocks.x),
                                    kLeaf * static_cast<int>(row % blocks.y), kLeaf * static_cast<int>(row / blocks.y));
    fillBlock(made[i]);
  });
  auto grid = openvdb::FloatGrid::create(background);
  grid->setName(name);
  grid->setTransform(vdbTransform(worldFromGrid));
  for (Block& block : made) {
    if (block.leaf) {
      grid->tree().addLeaf(block.leaf.release());
    } else if (block.active || std::bit_cast<std::uint32_t>(block.value) != std::bit_cast<std::uint32_t>(background)) {
      grid->tree().addTile(/*level=*/1, block.origin, block.value, block.active);
    }
  }
  return grid;
}

/// Calls visit(offset in the leaf, sample) for the samples of a block that lie in the grid.
template <class Visit>
void forSamples(GridView<const float> values, const openvdb::Coord& origin, Visit visit) {
  const glm::ivec3 first(origin.x(), origin.y(), origin.z());
  const glm::ivec3 end = glm::min(first + kLeaf, values.size);
  for (int x = first.x; x < end.x; ++x)
    for (int y = first.y; y < end.y; ++y)
      for (int z = first.z; z < end.z; ++z) visit(Leaf::coordToOffset(openvdb::Coord(x, y, z)), values(x, y, z));
}

bool isWhole(GridView<const float> values, const openvdb::Coord& origin) {
  return origin.x() + kLeaf <= values.size.x && origin.y() + kLeaf <= values.size.y &&
         origin.z() + kLeaf <= values.size.z;
}

}  // namespace

openvdb::math::Transform::Ptr vdbTransform(const glm::dmat4& m) {
  using namespace openvdb::math;
  const bool aligned = m[0].x > 0 && m[1].y > 0 && m[2].z > 0 && m[0].y == 0 && m[0].z == 0 && m[1].x == 0 &&
                       m[1].z == 0 && m[2].x == 0 && m[2].y == 0;
  const openvdb::Vec3d translation(m[3].x, m[3].y, m[3].z);
  try {
    MapBase::Ptr map;
    if (aligned && m[0].x == m[1].y && m[1].y == m[2].z) {
      map = std::make_shared<UniformScaleTranslateMap>(m[0].x, translation);
    } else if (aligned) {
      map = std::make_shared<ScaleTranslateMap>(openvdb::Vec3d(m[0].x, m[1].y, m[2].z), translation);
    } else {
      Mat4d rows = Mat4d::identity();
      for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 3; ++row) rows(column, row) = m[column][row];
      map = std::make_shared<AffineMap>(rows);
    }
    return std::make_shared<Transform>(map);
  } catch (const openvdb::Exception& error) {
    throw OutputError(fmt::format("VDB: cannot store this transform: {}", error.what()));
  }
}

openvdb::FloatGrid::Ptr denseVdbGrid(GridView<const float> values, const glm::dmat4& worldFromGrid,
                                     const std::string& name, float background) {
  return build(values, worldFromGrid, name, background, [&](Block& block) {
    block.active = true;
    block.value = values(block.origin.x(), block.origin.y(), block.origin.z());
    bool uniform = isWhole(values, block.origin);
    const auto bits = std::bit_cast<std::uint32_t>(block.value);
    if (uniform)
      forSamples(values, block.origin,
                 [&](unsigned, float value) { uniform &= std::bit_cast<std::uint32_t>(value) == bits; });
    if (uniform) return;
    block.leaf = std::make_unique<Leaf>(block.origin, background, /*active=*/false);
    forSamples(values, block.origin, [&](unsigned at, float value) { block.leaf->setValueOn(at, value); });
  });
}

openvdb::FloatGrid::Ptr levelSetVdbGrid(GridView<const float> values, const glm::dmat4& worldFromGrid,
                                        const std::string& name, float band) {
  auto grid = build(values, worldFromGrid, name, band, [&](Block& block) {
    bool touched = false, inside = true;
    forSamples(values, block.origin, [&](unsigned, float value) {
      touched |= std::abs(value) < band;
      inside &= value < 0;
    });
    block.value = inside && isWhole(values, block.origin) ? -band : band;
    // A border block may be inside up to the border only, and a block may change sign faster than its band is wide.
    bool mixed = false;
    forSamples(values, block.origin, [&](unsigned, float value) { mixed |= (value < 0) != (block.value < 0); });
    if (!touched && !mixed) return;
    block.leaf = std::make_unique<Leaf>(block.origin, band, /*active=*/false);
    forSamples(values, block.origin, [&](unsigned at, float value) {
      if (std::abs(value) < band) {
        block.leaf->setValueOn(at, value);
      } else {
        block.leaf->setValueOff(at, value < 0 ? -band : band);
      }
    });
  });
  grid->setGridClass(openvdb::GRID_LEVEL_SET);
  return grid;
}

std::string encodeVdb(GridView<const float> values, const glm::dmat4& worldFromGrid, const std::string& name,
                      bool levelSet) {
  // OpenVDB's own half width of a narrow band, in voxels.
  const double bandVoxels = openvdb::LEVEL_SET_HALF_WIDTH;
  const double smallest = smallestSpacing(values.spacing);
  const auto band = static_cast<float>(bandVoxels * smallest);
  const auto grid = levelSet ? levelSetVdbGrid(values, worldFromGrid, name, band)
                             : denseVdbGrid(values, worldFromGrid, name, /*background=*/0);
  openvdb::MetaMap metadata;
  metadata.insertMeta("creator", openvdb::StringMetadata("isolume"));
  return encodeVdbFile({grid}, metadata);
}

}  // namespace isolume
