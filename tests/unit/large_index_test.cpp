// Grids of more than 2^31 samples: no index may be computed in 32 bits.
#include <gtest/gtest.h>
#include <sys/mman.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "sweep/godunov/tile_handover.h"
#include "sweep/godunov/tile_io.h"
#include "sweep/godunov/wavefront.h"
#include "sweep/occlusion_sweep.h"

namespace isolume {
namespace {

constexpr glm::ivec3 kSize(2048, 2048, 1024);  // 2^32 samples, 16 GiB of floats
constexpr std::int64_t kCount = std::int64_t{1} << 32;

// Address space without memory: pages exist where they are written.
class SparseGrid {
 public:
  SparseGrid() {
    void* memory = mmap(nullptr, kCount * sizeof(float), PROT_READ | PROT_WRITE,
                        MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    data_ = memory == MAP_FAILED ? nullptr : static_cast<float*>(memory);
  }
  ~SparseGrid() {
    if (data_ != nullptr) munmap(data_, kCount * sizeof(float));
  }
  SparseGrid(const SparseGrid&) = delete;
  SparseGrid& operator=(const SparseGrid&) = delete;
  float* data() const { return data_; }

 private:
  float* data_ = nullptr;
};

TEST(LargeIndex, EveryOctantWalksFromCornerToCorner) {
  // From the start corner, the last row in canonical order ends at the opposite corner, in all octants.
  for (const Octant& octant : kOctants) {
    const OctantWalk walk = walkOctant(kSize, octant);
    const std::int64_t last = walk.row(kSize.y - 1, kSize.z - 1) + (kSize.x - 1) * walk.strideX;
    std::int64_t start = 0;
    if (octant.sweep.x < 0) start += 2047;
    if (octant.sweep.y < 0) start += std::int64_t{2047} << 11;
    if (octant.sweep.z < 0) start += std::int64_t{1023} << 22;
    EXPECT_EQ(walk.start, start);
    EXPECT_EQ(last, kCount - 1 - start);
  }
  EXPECT_EQ(voxelCount(kSize), static_cast<std::size_t>(kCount));
  EXPECT_EQ(GridView<float>(nullptr, kSize).index(2047, 2047, 1023), static_cast<std::size_t>(kCount - 1));
}

TEST(LargeIndex, TilesBeyondTheThirtySecondBitAreLoadedAndStored) {
  // The tile with the last sample of a grid of 2^32 goes out to its own place and comes back, forwards and backwards.
  const SparseGrid grid;
  if (grid.data() == nullptr) GTEST_SKIP() << "no 16 GiB of address space here";
  const TileGrid tiles = makeTileGrid(kSize);
  Tile tile;
  tile.block = tiles.blocks - 1;
  tile.layer = tiles.layers - 1;
  const TileSpan whole{0, kSize.x};
  for (const std::size_t s : {std::size_t{0}, std::size_t{7}}) {
    const OctantWalk walk = walkOctant(kSize, kOctants[s]);
    const TileOrigin origin = tiles.origin(tile, kOctants[s]);
    for (std::int64_t i = kCount - 3; i < kCount; ++i) grid.data()[i] = static_cast<float>(kCount - i);
    LargeArray<float> buffer = makeFilled(tileFloats(kSize.x, tiles.lanes), 0);
    loadTile(walk, origin, whole, grid.data(), buffer.get());
    for (std::int64_t i = kCount - 3; i < kCount; ++i) grid.data()[i] = 0;
    storeTile(walk, origin, whole, buffer.get(), grid.data());
    for (std::int64_t i = kCount - 3; i < kCount; ++i) EXPECT_EQ(grid.data()[i], static_cast<float>(kCount - i));
    EXPECT_EQ(grid.data()[(kCount - 3) & 0x7fffffff], 0) << "stored where 31 bits would point";
  }
}

TEST(LargeIndex, StartValuesBeyondTheThirtySecondBit) {
  // The last row's only solid sample makes its neighbours in that row start values, and lies on the cap itself.
  const SparseGrid levels;
  if (levels.data() == nullptr) GTEST_SKIP() << "no 16 GiB of address space here";
  levels.data()[kCount - 1] = 1;
  std::vector<float> row(2048);
  EXPECT_TRUE(startRow(GridView<const float>(levels.data(), kSize), DistanceStart::better, kUnsetDistance, 2047, 1023,
                       row.data()));
  EXPECT_TRUE(isFixed(row[2047]));
  EXPECT_LT(row[2047], 0);
  EXPECT_GT(row[2047], -1e-20F);
  EXPECT_TRUE(isFixed(row[2046]));
  EXPECT_FALSE(isFixed(row[2045]));
}

}  // namespace
}  // namespace isolume
