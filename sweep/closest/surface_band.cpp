#include "surface_band.h"

#include <array>
#include <atomic>
#include <cstdint>
#include <vector>

#include "closest_point.h"
#include "near_sets.h"
#include "neighbour_points.h"
#include "point_kernels.h"
#include "sweep/parallel.h"

namespace isolume {
namespace {

struct NewPoint {
  std::uint32_t index = 0;  // y * nx + x
  glm::vec3 offset{0};
};
using PlanePoints = std::vector<NewPoint>;

using PlaneList = std::vector<std::uint32_t>;  // samples of one plane: y * nx + x

class BandSolver {
 public:
  BandSolver(GridView<const float> level, OffsetField& field, BitGrid& set)
      : level_(level), interpolant_(level, smallestSpacing(level.spacing)), frame_(level), field_(field), set_(set),
        newest_(static_cast<std::size_t>(level.size.z)) {}

  void findSigns(BitGrid& inside) {
    parallelFor(newest_.size(), [&](std::size_t plane) {
      const int z = static_cast<int>(plane);
      std::fill_n(field_.component[0].data() + z * level_.strideZ(), level_.strideZ(), kUnsetOffset);
      for (int a = 1; a < 3; ++a) std::fill_n(field_.component[a].data() + z * level_.strideZ(), level_.strideZ(), 0.0F);
      for (int y = 0; y < level_.size.y; ++y) signRow(level_, y, z, inside);
    });
  }

  // Samples with a crossed edge, and caps.
  void seed(const BitGrid& inside) {
    parallelFor(newest_.size(), [&](std::size_t plane) {
      const int z = static_cast<int>(plane);
      BitRow crossed(static_cast<std::size_t>(inside.words())), cap(crossed.size());
      PlaneList list;
      for (int y = 0; y < level_.size.y; ++y) {
        crossedRow(inside, y, z, crossed);
        capRow(inside, y, z, cap);
        for (std::size_t w = 0; w < crossed.size(); ++w) {
          set_.row(y, z)[w] = crossed[w] | cap[w];
          crossed[w] &= ~cap[w];
        }
        forEachBit(cap.data(), inside.words(), [&](int x) { field_.set(level_.index(x, y, z), glm::vec3(0)); });
        forEachBit(crossed.data(), inside.words(), [&](int x) { list.push_back(indexOf(x, y)); });
      }
      PointBatch& batch = batchOf(list);
      if (frame_.fits() && batch.count > 0) {
        startAtCrossings(frame_, z, batch);
        refinePoints(frame_, z, batch);
      }
      finish(z, list, batch, [&](glm::ivec3 sample, glm::dvec3& offset) { seedOffset(interpolant_, sample, offset); });
    });
  }

  // One layer: the samples of targetRow(y, z, row) next to the set that are not in it, along x, then y, then z.
  template <class TargetRow>
  void grow(const TargetRow& targetRow) {
    parallelFor(newest_.size(), [&](std::size_t plane) {
      const int z = static_cast<int>(plane);
      place(z);
      PlaneList list;
      BitRow row(static_cast<std::size_t>(set_.words())), target(row.size());
      const auto extend = [&](int y) {
        for (std::size_t w = 0; w < row.size(); ++w) row[w] &= target[w] & ~set_.row(y, z)[w];
      };
      for (int y = 0; y < level_.size.y; ++y) {
        targetRow(y, z, target);
        std::copy_n(set_.row(y, z), row.size(), row.begin());
        spreadAlongX(row.data(), set_.words());
        extend(y);
        forEachBit(row.data(), set_.words(), [&](int x) { list.push_back(indexOf(x, y)); });
      }
      take(z, list, kAlongX);
      const std::size_t alongX = list.size();
      for (int y = 0; y < level_.size.y; ++y) {
        targetRow(y, z, target);
        std::copy_n(set_.row(y, z), row.size(), row.begin());
        for (const int from : {y - 1, y + 1})
          for (std::size_t w = 0; from >= 0 && from < level_.size.y && w < row.size(); ++w)
            row[w] |= set_.row(from, z)[w];
        extend(y);
        forEachBit(row.data(), set_.words(), [&](int x) { list.push_back(indexOf(x, y)); });
      }
      PlaneList second(list.begin() + static_cast<std::ptrdiff_t>(alongX), list.end());
      take(z, second, kAlongX | kAlongY);
      PointBatch& batch = batchOf(list);
      for (std::size_t i = 0; i < list.size(); ++i) {
        const glm::vec3 start = field_.at(level_.index(0, 0, z) + list[i]);
        batch.set(i, start, start);
      }
      refine(z, batch);
      for (std::size_t i = 0; i < list.size(); ++i) field_.set(level_.index(0, 0, z) + list[i], batch.point(i));
    });
    parallelFor(newest_.size(), [&](std::size_t plane) {
      const int z = static_cast<int>(plane);
      PlaneList list;
      BitRow row(static_cast<std::size_t>(set_.words())), target(row.size());
      for (int y = 0; y < level_.size.y; ++y) {
        targetRow(y, z, target);
        std::fill(row.begin(), row.end(), std::uint64_t{0});
        for (const int from : {z - 1, z + 1})
          for (std::size_t w = 0; from >= 0 && from < level_.size.z && w < row.size(); ++w)
            row[w] |= set_.row(y, from)[w];
        for (std::size_t w = 0; w < row.size(); ++w) row[w] &= target[w] & ~set_.row(y, z)[w];
        forEachBit(row.data(), set_.words(), [&](int x) { list.push_back(indexOf(x, y)); });
      }
      PointBatch& batch = batchOf(list);
      for (std::size_t i = 0; i < batch.x.size(); ++i) batch.set(i, {kUnsetOffset, 0, 0}, {});
      takeFromNeighbours(field_, frame_.step, z, kAlongZ, 1, batch);
      refine(z, batch);
      for (std::size_t i = 0; i < list.size(); ++i) newest_[plane].push_back({list[i], batch.point(i)});
    });
  }
  // Points of samples of the set that neighbours know better.
  long relax(float share) {
    std::atomic<long> improved = 0;
    parallelFor(newest_.size(), [&](std::size_t plane) {
      const int z = static_cast<int>(plane);
      PlaneList list;
      for (int y = 0; y < level_.size.y; ++y)
        forEachBit(set_.row(y, z), set_.words(), [&](int x) { list.push_back(indexOf(x, y)); });
      PointBatch* batch = &batchOf(list);
      for (std::size_t i = 0; i < list.size(); ++i) batch->set(i, field_.at(level_.index(0, 0, z) + list[i]), {});
      if (!list.empty()) batch->pad();
      takeFromNeighbours(field_, frame_.step, z, kAlongX | kAlongY | kAlongZ, share, *batch);
      PlaneList better;
      std::vector<glm::vec3> start;
      for (std::size_t i = 0; i < list.size(); ++i)
        if (batch->settled[i] != 0) {
          better.push_back(list[i]);
          start.push_back(batch->point(i));
        }
      batch = &batchOf(better);
      for (std::size_t i = 0; i < better.size(); ++i) batch->set(i, start[i], start[i]);
      refine(z, *batch);
      improved += static_cast<long>(better.size());
      for (std::size_t i = 0; i < better.size(); ++i) newest_[plane].push_back({better[i], batch->point(i)});
    });
    placeAll();
    return improved;
  }
  void placeAll() {
    parallelFor(newest_.size(), [&](std::size_t plane) { place(static_cast<int>(plane)); });
  }

  static inline std::atomic<long> total, unsettled;
 private:
  std::uint32_t indexOf(int x, int y) const { return static_cast<std::uint32_t>(y * level_.strideY() + x); }
  glm::ivec3 sampleOf(std::uint32_t index, int z) const {
    const auto nx = static_cast<std::uint32_t>(level_.size.x);
    return {static_cast<int>(index % nx), static_cast<int>(index / nx), z};
  }

  PointBatch& batchOf(const PlaneList& list) const {
    static thread_local PointBatch batch;
    batch.resize(list.size());
    for (std::size_t i = 0; i < list.size(); ++i) {
      const glm::ivec3 p = sampleOf(list[i], 0);
      batch.x[i] = p.x;
      batch.y[i] = p.y;
    }
    std::fill(batch.settled.begin(), batch.settled.end(), std::uint8_t{0});
    if (batch.count > 0) batch.pad();
    return batch;
  }

  // Writes the batch into the field; what has not settled is solved by solveAlone(sample, offset) first.
  template <class SolveAlone>
  void finish(int z, const PlaneList& list, const PointBatch& batch, const SolveAlone& solveAlone) {
    const std::size_t first = level_.index(0, 0, z);
    for (std::size_t i = 0; i < list.size(); ++i) {
      glm::vec3 point = batch.point(i);
      if (batch.settled[i] == 0) {
        glm::dvec3 offset(point);
        solveAlone({batch.x[i], batch.y[i], z}, offset);
        point = glm::vec3(offset);
        unsettled++;
      }
      total++;
      field_.set(first + list[i], point);
    }
  }

  // Writes the points found for plane z into the field.
  void place(int z) {
    PlanePoints& points = newest_[static_cast<std::size_t>(z)];
    for (const NewPoint& point : points) {
      const glm::ivec3 p = sampleOf(point.index, z);
      field_.set(level_.index(0, 0, z) + point.index, point.offset);
      set_.mark(p.x, p.y, p.z);
    }
    points.clear();
  }

  void take(int z, const PlaneList& list, unsigned axes) {
    PointBatch& batch = batchOf(list);
    for (std::size_t i = 0; i < batch.x.size(); ++i) batch.set(i, {kUnsetOffset, 0, 0}, {});
    takeFromNeighbours(field_, frame_.step, z, axes, 1, batch);
    for (std::size_t i = 0; i < list.size(); ++i) {
      const glm::ivec3 p = sampleOf(list[i], z);
      field_.set(level_.index(0, 0, z) + list[i], batch.point(i));
      set_.mark(p.x, p.y, p.z);
    }
  }

  void refine(int z, PointBatch& batch) {
    if (batch.count == 0) return;
    std::fill(batch.settled.begin(), batch.settled.end(), std::uint8_t{0});
    if (frame_.fits()) {
      batch.pad();
      refinePoints(frame_, z, batch);
    }
    for (std::size_t i = 0; i < batch.count; ++i) {
      total++;
      if (batch.settled[i] != 0) continue;
      unsettled++;
      glm::dvec3 offset(batch.point(i));
      refineOffset(interpolant_, {batch.x[i], batch.y[i], z}, offset);
      batch.set(i, glm::vec3(offset), {});
    }
  }

  GridView<const float> level_;
  LevelInterpolant interpolant_;
  PointFrame frame_;
  OffsetField& field_;
  BitGrid& set_;
  std::vector<PlanePoints> newest_;
};

}  // namespace
long bandTotal(){return BandSolver::total;}
long bandUnsettled(){return BandSolver::unsettled;}

std::size_t startOffsets(GridView<const float> level, int layers, OffsetField& field) {
  BitGrid set(level.size);
  BandSolver solver(level, field, set);
  {
    BitGrid inside(level.size);
    solver.findSigns(inside);
    solver.seed(inside);
    solver.grow([&](int y, int z, BitRow& row) { cornerRow(inside, y, z, row); });
  }
  for (int layer = 0; layer < layers; ++layer)
    solver.grow([&](int, int, BitRow& row) { std::fill(row.begin(), row.end(), ~std::uint64_t{0}); row.back() = set.lastWordMask(); });
  solver.placeAll();
  const char* e = getenv("RELAX");
  for (int i = 0; e && i < atoi(e); ++i) { long k = solver.relax(getenv("SHARE") ? atof(getenv("SHARE")) : .999F); if (getenv("SHOW")) printf("relaxed %ld\n", k); }
  std::size_t count = 0;
  for (int z = 0; z < level.size.z; ++z)
    for (int y = 0; y < level.size.y; ++y)
      for (int w = 0; w < set.words(); ++w) count += static_cast<std::size_t>(std::popcount(set.row(y, z)[w]));
  return count;
}

}  // namespace isolume
