#include "band_solver.h"

#include <algorithm>
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
  batch.padPlaces();
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
    if (frame_.fits()) startAtCrossings(frame_, z, batch);
    search(z, true, batch);
    const std::size_t first = planeIndex(z);
    for (std::size_t i = 0; i < batch.count; ++i)
      field_.set(first + static_cast<std::size_t>(batch.y[i] * level_.strideY() + batch.x[i]), batch.point(i));
  });
}

// Points for samples that have none, from the neighbours that have: across faces, else edges, else corners.
void BandSolver::start(int z, const std::vector<glm::ivec2>& samples, PointBatch& batch) const {
  static thread_local std::vector<std::size_t> origin;
  static thread_local PointBatch part;
  fill(samples, batch);
  takeFromNeighbours(field_, frame_.step, z, faceSteps(), 1, batch);
  for (const NeighbourSteps steps : {edgeSteps(), cornerSteps()}) {
    origin.clear();
    for (std::size_t i = 0; i < batch.count; ++i)
      if (batch.state[i] != PointState::settled) origin.push_back(i);
    if (origin.empty()) return;
    part.resize(origin.size());
    for (std::size_t i = 0; i < origin.size(); ++i) {
      part.x[i] = batch.x[origin[i]];
      part.y[i] = batch.y[origin[i]];
    }
    part.padPlaces();
    takeFromNeighbours(field_, frame_.step, z, steps, 1, part);
    for (std::size_t i = 0; i < origin.size(); ++i) {
      batch.set(origin[i], part.point(i));
      batch.state[origin[i]] = part.state[i];
    }
  }
}

// Searches for the samples of the rows that are not in the set; rowOf(y, z, row) makes a row.
template <class RowOf>
void BandSolver::growTo(const RowOf& rowOf) {
  parallelFor(found_.size(), [&](std::size_t plane) {
    const int z = static_cast<int>(plane);
    BitRow row(static_cast<std::size_t>(set_.words()));
    std::vector<glm::ivec2> samples;
    for (int y = 0; y < level_.size.y; ++y) {
      rowOf(y, z, row);
      const std::uint64_t* own = set_.row(y, z);
      for (std::size_t w = 0; w < row.size(); ++w) row[w] &= ~own[w];
      appendRow(row, y, samples);
    }
    if (samples.empty()) return;
    PointBatch& batch = threadBatch();
    start(z, samples, batch);
    search(z, false, batch);
    keep(plane, batch);
  });
  placeFound();
}

void BandSolver::growToCorners(const BitGrid& inside) {
  growTo([&](int y, int z, BitRow& row) {
    // Far from the set the row of corners is not worth its making.
    grownRow(set_, y, z, row);
    if (std::all_of(row.begin(), row.end(), [](std::uint64_t word) { return word == 0; })) return;
    cornerRow(inside, y, z, row);
  });
}

void BandSolver::grow() {
  growTo([&](int y, int z, BitRow& row) { grownRow(set_, y, z, row); });
}

void BandSolver::growAcrossFaces() {
  growTo([&](int y, int z, BitRow& row) { grownAcrossFacesRow(set_, y, z, row); });
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
          grownAcrossFacesRow(changed, y, z, row);
          for (std::size_t w = 0; w < row.size(); ++w) row[w] &= set_.row(y, z)[w];
        }
        appendRow(row, y, samples);
      }
      if (samples.empty()) return;
      PointBatch& batch = threadBatch();
      fill(samples, batch);
      takeFromNeighbours(field_, frame_.step, z, faceSteps(), kWorthTaking, batch);
      std::size_t better = 0;
      for (std::size_t i = 0; i < batch.count; ++i)
        if (batch.state[i] == PointState::settled) batch.copyStart(better++, i);
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
