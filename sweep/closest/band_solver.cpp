#include "band_solver.h"

#include <algorithm>
#include <array>
#include <atomic>

#include "closest_point.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

// A neighbour's point replaces a sample's own if its squared distance is less than this share: what Newton's steps
// leave is not worth another search.
constexpr float kWorthTaking = 0.999F;

// Rows of a block along y. With kBatchPlanes planes, and as many more as points reach, of 512 samples each: 1.3 MB.
constexpr int kBlockRows = 32;

// The buffer of one thread, empty.
PointBatch& threadBatch(int firstPlane) {
  static thread_local PointBatch batch;
  batch.clear(firstPlane);
  return batch;
}

bool isEmpty(const BitRow& row) {
  return std::all_of(row.begin(), row.end(), [](std::uint64_t word) { return word == 0; });
}

}  // namespace

BandSolver::BandSolver(GridView<const float> level, OffsetField& field, BitGrid& set)
    : level_(level),
      interpolant_(level, smallestSpacing(level.spacing)),
      frame_(level),
      field_(field),
      set_(set),
      next_(level.size),
      blocks_((level.size.y + kBlockRows - 1) / kBlockRows, (level.size.z + kBatchPlanes - 1) / kBatchPlanes),
      hasPoints_(static_cast<std::size_t>(blocks_.x) * static_cast<std::size_t>(blocks_.y), 0),
      found_(hasPoints_.size()) {}

BandSolver::Block BandSolver::block(std::size_t index) const {
  const int at = static_cast<int>(index);
  const glm::ivec2 first = glm::ivec2(at % blocks_.x * kBlockRows, at / blocks_.x * kBatchPlanes);
  return {first, glm::min(first + glm::ivec2(kBlockRows, kBatchPlanes), glm::ivec2(level_.size.y, level_.size.z))};
}

// The marked blocks and those that touch one.
std::vector<std::size_t> BandSolver::blocksNear(const std::vector<char>& marked) const {
  std::vector<std::size_t> near;
  for (int z = 0; z < blocks_.y; ++z)
    for (int y = 0; y < blocks_.x; ++y) {
      bool touches = false;
      for (int otherZ = std::max(z - 1, 0); otherZ <= std::min(z + 1, blocks_.y - 1); ++otherZ)
        for (int otherY = std::max(y - 1, 0); otherY <= std::min(y + 1, blocks_.x - 1); ++otherY)
          touches = touches || marked[static_cast<std::size_t>(otherZ * blocks_.x + otherY)] != 0;
      if (touches) near.push_back(static_cast<std::size_t>(z * blocks_.x + y));
    }
  return near;
}

template <class OnRow>
void BandSolver::forRows(const Block& block, const OnRow& onRow) {
  for (int z = block.first.y; z < block.end.y; ++z)
    for (int y = block.first.x; y < block.end.x; ++y) onRow(y, z);
}

// Closest points from the trials; what the kernels cannot do is done one by one.
void BandSolver::search(bool isSeed, PointBatch& batch) const {
  if (batch.count == 0) return;
  if (frame_.fits()) {
    searchPoints(frame_, batch);
    if (isSeed) doubtOtherSheets(frame_, batch);
  } else {
    std::fill(batch.state.begin(), batch.state.end(), PointState::failed);
  }
  for (std::size_t i = 0; i < batch.count; ++i) {
    const PointState state = batch.state[i];
    if (state == PointState::settled || (state == PointState::stuck && !isSeed)) continue;
    glm::dvec3 offset(batch.point(i));
    if (isSeed) {
      seedOffset(interpolant_, batch.sample(i), offset);
    } else {
      refineOffset(interpolant_, batch.sample(i), offset);
    }
    batch.set(i, glm::vec3(offset));
  }
}

void BandSolver::seed(const BitGrid& inside) {
  parallelFor(found_.size(), [&](std::size_t index) {
    const Block rows = block(index);
    BitRow crossed(static_cast<std::size_t>(inside.words())), cap(crossed.size());
    PointBatch& batch = threadBatch(rows.first.y);
    forRows(rows, [&](int y, int z) {
      crossedRow(inside, y, z, crossed);
      capRow(inside, y, z, cap);
      if (!isEmpty(crossed) || !isEmpty(cap)) hasPoints_[index] = 1;
      for (std::size_t w = 0; w < crossed.size(); ++w) {
        set_.row(y, z)[w] = crossed[w] | cap[w];
        crossed[w] &= ~cap[w];
      }
      forEachBit(cap.data(), inside.words(), [&](int x) { field_.set(level_.index(x, y, z), glm::vec3(0)); });
      batch.makeRoom(batch.count + crossed.size() * kWordBits);
      forEachBit(crossed.data(), inside.words(), [&](int x) {
        batch.x[batch.count] = x;
        batch.y[batch.count] = y;
        batch.z[batch.count++] = z;
      });
    });
    if (batch.count == 0) return;
    batch.pad();
    if (frame_.fits()) startAtCrossings(frame_, batch);
    search(true, batch);
    place(batch);
  });
}

// Searches for the samples of the rows that are not in the set; rowOf(y, z, row) makes a row.
template <class RowOf>
void BandSolver::growTo(const RowOf& rowOf) {
  const std::vector<std::size_t> blocks = blocksNear(hasPoints_);
  parallelFor(blocks.size(), [&](std::size_t i) {
    const Block rows = block(blocks[i]);
    BitRow row(static_cast<std::size_t>(set_.words()));
    PointBatch& batch = threadBatch(rows.first.y);
    forRows(rows, [&](int y, int z) {
      rowOf(y, z, row);
      const std::uint64_t* own = set_.row(y, z);
      std::uint64_t* next = next_.row(y, z);
      for (std::size_t w = 0; w < row.size(); ++w) {
        row[w] &= ~own[w];
        next[w] = own[w] | row[w];
      }
      if (!isEmpty(row)) appendStarts(known(), y, z, row, batch);
    });
    if (batch.count != 0) hasPoints_[blocks[i]] = 1;
    search(false, batch);
    place(batch);
  });
  std::swap(set_, next_);
}

void BandSolver::growToCorners(const BitGrid& inside) {
  growTo([&](int y, int z, BitRow& row) {
    // Far from the set the row of corners is not worth its making.
    grownRow(set_, Across::corners, y, z, row);
    if (!isEmpty(row)) cornerRow(inside, y, z, row);
  });
}

void BandSolver::grow(Across across) {
  growTo([&](int y, int z, BitRow& row) { grownRow(set_, across, y, z, row); });
}

void BandSolver::reseedCorners(const BitGrid& inside) {
  parallelFor(found_.size(), [&](std::size_t index) {
    if (hasPoints_[index] == 0) return;
    const Block rows = block(index);
    BitRow crossed(static_cast<std::size_t>(set_.words())), cap(crossed.size());
    PointBatch& batch = threadBatch(rows.first.y);
    forRows(rows, [&](int y, int z) {
      crossedRow(inside, y, z, crossed);
      capRow(inside, y, z, cap);
      for (std::size_t w = 0; w < crossed.size(); ++w) crossed[w] = set_.row(y, z)[w] & ~(crossed[w] | cap[w]);
      if (!isEmpty(crossed)) appendDoubtful(known(), y, z, crossed, batch);
    });
    for (std::size_t i = 0; i < batch.count; ++i) {
      glm::dvec3 offset(0);
      if (!seedOffset(interpolant_, batch.sample(i), offset)) continue;
      const glm::vec3 point(offset);
      if (squaredLength(point) < squaredLength(batch.point(i))) found_[index].push_back({batch.sample(i), point});
    }
  });
  placeFound();
}

void BandSolver::place(const PointBatch& batch) {
  for (std::size_t i = 0; i < batch.count; ++i)
    field_.set(level_.index(batch.x[i], batch.y[i], batch.z[i]), batch.point(i));
}

void BandSolver::placeFound() {
  parallelFor(found_.size(), [&](std::size_t index) {
    for (const NewPoint& point : found_[index])
      field_.set(level_.index(point.at.x, point.at.y, point.at.z), point.offset);
    found_[index].clear();
  });
}

void BandSolver::relax(int rounds) {
  BitGrid& changed = next_;
  std::vector<char> blockChanged = hasPoints_;
  for (int round = 0; round < rounds; ++round) {
    std::atomic<std::size_t> count = 0;
    const std::vector<std::size_t> blocks = blocksNear(blockChanged);
    parallelFor(blocks.size(), [&](std::size_t i) {
      const std::size_t index = blocks[i];
      const Block rows = block(index);
      BitRow row(static_cast<std::size_t>(set_.words()));
      PointBatch& batch = threadBatch(rows.first.y);
      forRows(rows, [&](int y, int z) {
        if (round == 0) {
          std::copy_n(set_.row(y, z), row.size(), row.begin());
        } else {
          grownRow(changed, Across::faces, y, z, row);
          for (std::size_t w = 0; w < row.size(); ++w) row[w] &= set_.row(y, z)[w];
        }
        if (!isEmpty(row)) appendNearer(known(), y, z, row, kWorthTaking, batch);
      });
      search(false, batch);
      for (std::size_t k = 0; k < batch.count; ++k) found_[index].push_back({batch.sample(k), batch.point(k)});
      count += batch.count;
    });
    if (count == 0) return;
    parallelFor(found_.size(), [&](std::size_t index) {
      if (blockChanged[index] != 0)
        forRows(block(index), [&](int y, int z) { std::fill_n(changed.row(y, z), changed.words(), std::uint64_t{0}); });
      blockChanged[index] = found_[index].empty() ? 0 : 1;
      for (const NewPoint& point : found_[index]) changed.mark(point.at.x, point.at.y, point.at.z);
    });
    placeFound();
  }
}

}  // namespace isolume
