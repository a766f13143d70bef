#include "band_solver.h"

#include <atomic>

#include "closest_point.h"
#include "neighbour_points.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

// A neighbour's point replaces a sample's own if its squared distance is less than this share: what Newton's steps
// leave is not worth another search.
constexpr float kWorthTaking = 0.999F;

// Buffers of one thread.
PointBatch& threadBatch() {
  static thread_local PointBatch batch;
  return batch;
}

void appendRow(const BitRow& row, int y, std::vector<glm::ivec2>& samples) {
  forEachBit(row.data(), static_cast<int>(row.size()), [&](int x) { samples.emplace_back(x, y); });
}

void fill(const std::vector<glm::ivec2>& samples, PointBatch& batch) {
  batch.resize(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    batch.x[i] = samples[i].x;
    batch.y[i] = samples[i].y;
  }
}

}  // namespace

BandSolver::BandSolver(GridView<const float> level, OffsetField& field, BitGrid& set)
    : level_(level),
      interpolant_(level, smallestSpacing(level.spacing)),
      frame_(level),
      field_(field),
      set_(set),
      found_(static_cast<std::size_t>(level.size.z)) {}

// Closest points from the trials; what the kernels cannot do is done one by one.
void BandSolver::search(int z, bool isSeed, PointBatch& batch) const {
  if (batch.count == 0) return;
  if (frame_.fits()) {
    searchPoints(frame_, z, batch);
    if (isSeed) doubtOtherSheets(frame_, z, batch);
  } else {
    std::fill(batch.state.begin(), batch.state.end(), PointState::failed);
  }
  for (std::size_t i = 0; i < batch.count; ++i) {
    const PointState state = batch.state[i];
    if (state == PointState::settled || (state == PointState::stuck && !isSeed)) continue;
    glm::dvec3 offset(batch.point(i));
    const glm::ivec3 sample(batch.x[i], batch.y[i], z);
    if (isSeed) {
      seedOffset(interpolant_, sample, offset);
    } else {
      refineOffset(interpolant_, sample, offset);
    }
    batch.set(i, glm::vec3(offset));
  }
}

void BandSolver::write(int z, const PointBatch& batch) {
  const std::size_t first = planeIndex(z);
  for (std::size_t i = 0; i < batch.count; ++i) {
    field_.set(first + static_cast<std::size_t>(batch.y[i] * level_.strideY() + batch.x[i]), batch.point(i));
    set_.mark(batch.x[i], batch.y[i], z);
  }
}

void BandSolver::seed(const BitGrid& inside) {
  parallelFor(found_.size(), [&](std::size_t plane) {
    const int z = static_cast<int>(plane);
    std::fill_n(field_.component[0].data() + planeIndex(z), level_.strideZ(), kUnsetOffset);
    BitRow crossed(static_cast<std::size_t>(inside.words())), cap(crossed.size());
    std::vector<glm::ivec2> samples;
    for (int y = 0; y < level_.size.y; ++y) {
      crossedRow(inside, y, z, crossed);
      capRow(inside, y, z, cap);
      for (std::size_t w = 0; w < crossed.size(); ++w) {
        set_.row(y, z)[w] = crossed[w] | cap[w];
        crossed[w] &= ~cap[w];
      }
      forEachBit(cap.data(), inside.words(), [&](int x) { field_.set(level_.index(x, y, z), glm::vec3(0)); });
      appendRow(crossed, y, samples);
    }
    if (samples.empty()) return;
    PointBatch& batch = threadBatch();
    fill(samples, batch);
    batch.pad();
    if (frame_.fits()) startAtCrossings(frame_, z, batch);
    search(z, true, batch);
    write(z, batch);
  });
}

// The nearest points of neighbours along those axes, as starts.
void BandSolver::takeAll(int z, const std::vector<glm::ivec2>& samples, unsigned axes, PointBatch& batch) const {
  fill(samples, batch);
  for (std::size_t i = 0; i < batch.count; ++i) batch.set(i, {kUnsetOffset, 0, 0});
  batch.pad();
  takeFromNeighbours(field_, frame_.step, z, axes, 1, batch);
}

// row |= row (y, z) of the set; nothing beyond the grid.
void BandSolver::orRow(int y, int z, BitRow& row) const {
  if (y < 0 || z < 0 || y >= level_.size.y || z >= level_.size.z) return;
  const std::uint64_t* from = set_.row(y, z);
  for (std::size_t w = 0; w < row.size(); ++w) row[w] |= from[w];
}

// Along x, then y, then z, so that every new sample has a neighbour across a face to start from. The first two stay
// within a plane; the third reads the planes beside it, and writes when all have read. missing(y, z, row) takes from a
// row of candidates those that are not wanted or in the set.
template <class Missing>
void BandSolver::growWithin(const Missing& missing) {
  const auto words = static_cast<std::size_t>(set_.words());
  parallelFor(found_.size(), [&](std::size_t plane) {
    const int z = static_cast<int>(plane);
    PointBatch& batch = threadBatch();
    BitRow row(words);
    std::vector<glm::ivec2> all, samples;
    for (const unsigned axis : {kAlongX, kAlongY}) {
      samples.clear();
      for (int y = 0; y < level_.size.y; ++y) {
        std::fill(row.begin(), row.end(), std::uint64_t{0});
        if (axis == kAlongX) {
          orRow(y, z, row);
          spreadAlongX(row.data(), set_.words());
        } else {
          orRow(y - 1, z, row);
          orRow(y + 1, z, row);
        }
        missing(y, z, row);
        appendRow(row, y, samples);
      }
      if (samples.empty()) continue;
      takeAll(z, samples, axis == kAlongX ? kAlongX : kAlongX | kAlongY, batch);
      write(z, batch);
      all.insert(all.end(), samples.begin(), samples.end());
    }
    if (all.empty()) return;
    fill(all, batch);
    for (std::size_t i = 0; i < all.size(); ++i) batch.set(i, field_.at(level_.index(all[i].x, all[i].y, z)));
    search(z, false, batch);
    write(z, batch);
  });
  parallelFor(found_.size(), [&](std::size_t plane) {
    const int z = static_cast<int>(plane);
    BitRow row(words);
    std::vector<glm::ivec2> samples;
    for (int y = 0; y < level_.size.y; ++y) {
      std::fill(row.begin(), row.end(), std::uint64_t{0});
      orRow(y, z - 1, row);
      orRow(y, z + 1, row);
      missing(y, z, row);
      appendRow(row, y, samples);
    }
    if (samples.empty()) return;
    PointBatch& batch = threadBatch();
    takeAll(z, samples, kAlongZ, batch);
    search(z, false, batch);
    keep(plane, batch);
  });
  placeFound();
}

void BandSolver::growToCorners(const BitGrid& inside) {
  growWithin([&](int y, int z, BitRow& row) {
    std::uint64_t any = 0;
    for (std::size_t w = 0; w < row.size(); ++w) any |= row[w] &= ~set_.row(y, z)[w];
    if (any == 0) return;
    BitRow corners(row.size());
    cornerRow(inside, y, z, corners);
    for (std::size_t w = 0; w < row.size(); ++w) row[w] &= corners[w];
  });
}

void BandSolver::reseedCorners(const BitGrid& inside) {
  parallelFor(found_.size(), [&](std::size_t plane) {
    const int z = static_cast<int>(plane);
    BitRow crossed(static_cast<std::size_t>(set_.words())), cap(crossed.size());
    std::vector<glm::ivec2> samples;
    for (int y = 0; y < level_.size.y; ++y) {
      crossedRow(inside, y, z, crossed);
      capRow(inside, y, z, cap);
      for (std::size_t w = 0; w < crossed.size(); ++w) crossed[w] = set_.row(y, z)[w] & ~(crossed[w] | cap[w]);
      appendRow(crossed, y, samples);
    }
    if (samples.empty()) return;
    PointBatch& batch = threadBatch();
    fill(samples, batch);
    for (std::size_t i = 0; i < samples.size(); ++i)
      batch.set(i, field_.at(level_.index(samples[i].x, samples[i].y, z)));
    batch.pad();
    doubtNeighbours(field_, frame_.step, z, batch);
    for (std::size_t i = 0; i < batch.count; ++i) {
      if (batch.state[i] != PointState::stuck) continue;
      glm::dvec3 offset(0);
      if (!seedOffset(interpolant_, {batch.x[i], batch.y[i], z}, offset)) continue;
      const glm::vec3 point(offset);
      if (squaredLength(point) < squaredLength(batch.point(i))) found_[plane].push_back({samples[i], point});
    }
  });
  placeFound();
}

void BandSolver::grow() {
  growWithin([&](int y, int z, BitRow& row) {
    for (std::size_t w = 0; w < row.size(); ++w) row[w] &= ~set_.row(y, z)[w];
    row.back() &= set_.lastWordMask();
  });
}

void BandSolver::growAcrossFaces() {
  parallelFor(found_.size(), [&](std::size_t plane) {
    const int z = static_cast<int>(plane);
    BitRow row(static_cast<std::size_t>(set_.words()));
    std::vector<glm::ivec2> samples;
    for (int y = 0; y < level_.size.y; ++y) {
      std::fill(row.begin(), row.end(), std::uint64_t{0});
      orRow(y, z, row);
      spreadAlongX(row.data(), set_.words());
      orRow(y - 1, z, row);
      orRow(y + 1, z, row);
      orRow(y, z - 1, row);
      orRow(y, z + 1, row);
      for (std::size_t w = 0; w < row.size(); ++w) row[w] &= ~set_.row(y, z)[w];
      row.back() &= set_.lastWordMask();
      appendRow(row, y, samples);
    }
    if (samples.empty()) return;
    PointBatch& batch = threadBatch();
    takeAll(z, samples, kAlongX | kAlongY | kAlongZ, batch);
    search(z, false, batch);
    keep(plane, batch);
  });
  placeFound();
}

void BandSolver::keep(std::size_t plane, const PointBatch& batch) {
  found_[plane].reserve(batch.count);
  for (std::size_t i = 0; i < batch.count; ++i) found_[plane].push_back({{batch.x[i], batch.y[i]}, batch.point(i)});
}

void BandSolver::placeFound() {
  parallelFor(found_.size(), [&](std::size_t plane) {
    const int z = static_cast<int>(plane);
    for (const NewPoint& point : found_[plane]) {
      field_.set(level_.index(point.at.x, point.at.y, z), point.offset);
      set_.mark(point.at.x, point.at.y, z);
    }
    found_[plane].clear();
  });
}

void BandSolver::relax(int rounds) {
  BitGrid changed(level_.size);
  std::vector<char> planeChanged(found_.size(), 1);
  for (int round = 0; round < rounds; ++round) {
    std::atomic<std::size_t> count = 0;
    parallelFor(found_.size(), [&](std::size_t plane) {
      const int z = static_cast<int>(plane);
      const std::size_t last = std::min(plane + 1, found_.size() - 1);
      if (std::count(planeChanged.begin() + std::max(z - 1, 0), planeChanged.begin() + static_cast<int>(last) + 1, 1) ==
          0)
        return;
      BitRow row(static_cast<std::size_t>(set_.words()));
      std::vector<glm::ivec2> samples;
      for (int y = 0; y < level_.size.y; ++y) {
        if (round == 0) {
          std::copy_n(set_.row(y, z), row.size(), row.begin());
        } else {
          grownRow(changed, y, z, row);
          for (std::size_t w = 0; w < row.size(); ++w) row[w] &= set_.row(y, z)[w];
        }
        appendRow(row, y, samples);
      }
      if (samples.empty()) return;
      PointBatch& batch = threadBatch();
      fill(samples, batch);
      for (std::size_t i = 0; i < samples.size(); ++i)
        batch.set(i, field_.at(level_.index(samples[i].x, samples[i].y, z)));
      batch.pad();
      takeFromNeighbours(field_, frame_.step, z, kAlongX | kAlongY | kAlongZ, kWorthTaking, batch);
      std::size_t better = 0;
      for (std::size_t i = 0; i < batch.count; ++i)
        if (batch.state[i] == PointState::settled) batch.copy(better++, batch, i);
      if (better == 0) return;
      batch.resize(better);
      search(z, false, batch);
      keep(plane, batch);
      count += better;
    });
    if (count == 0) return;
    parallelFor(found_.size(), [&](std::size_t plane) {
      const int z = static_cast<int>(plane);
      if (planeChanged[plane] != 0)
        std::fill_n(changed.row(0, z), static_cast<std::ptrdiff_t>(changed.words()) * level_.size.y, std::uint64_t{0});
      planeChanged[plane] = found_[plane].empty() ? 0 : 1;
      for (const NewPoint& point : found_[plane]) changed.mark(point.at.x, point.at.y, z);
    });
    placeFound();
  }
}

}  // namespace isolume
