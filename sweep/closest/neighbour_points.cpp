#include "neighbour_points.h"

#include <array>
#include <bit>
#include <climits>
#include <cstring>
#include <span>

#include "closest_point.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sweep/closest/neighbour_points.cpp"
#include <hwy/cache_control.h>
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "bit_mask-inl.h"
#include "point_vector-inl.h"

#ifndef ISOLUME_NEIGHBOUR_STEPS
#define ISOLUME_NEIGHBOUR_STEPS
namespace isolume {

// The steps to neighbours across faces, edges and corners, each in rising z, y, x. Rows: dy + 1 + 3 (dz + 1).
struct Step {
  int row = 0, dx = 0;
};
struct AllSteps {
  std::array<Step, 26> all{};
  std::array<std::size_t, 4> end{};  // of those along 1, 2 and 3 axes

  constexpr std::span<const Step> along(std::size_t axes) const {
    return {all.data() + end[axes - 1], end[axes] - end[axes - 1]};
  }
};
inline constexpr int kRows = 9;
constexpr AllSteps makeSteps() {
  AllSteps steps;
  std::size_t count = 0;
  for (int axes = 1; axes <= 3; ++axes) {
    for (int row = 0; row < kRows; ++row)
      for (int dx = -1; dx <= 1; ++dx)
        if ((row % 3 != 1) + (row / 3 != 1) + (dx != 0) == axes) steps.all[count++] = {row, dx};
    steps.end[static_cast<std::size_t>(axes)] = count;
  }
  return steps;
}
inline constexpr AllSteps kSteps = makeSteps();

// Offsets shorter than this are too inexact for a direction, in smallest spacings: Newton's steps leave 1e-6.
inline constexpr float kShortestNormal = 1e-3F;

// Bits in four bytes: a vector's lanes and up to seven before them.
inline constexpr unsigned kFourBytes = 32;
static_assert(kBatchGroup + CHAR_BIT - 1 <= kFourBytes && kFourBytes < kWordBits);

// Rows of the next plane that are fetched so far ahead cost a tenth to a fifth less of the whole band.
inline constexpr int kRowsAhead = 4;

}  // namespace isolume
#endif

HWY_BEFORE_NAMESPACE();
namespace isolume::HWY_NAMESPACE {

// The lanes of one vector: samples x, x + 1, ... of a row; one bit for each that is meant.
struct RowPart {
  int x = 0;
  std::uint64_t bits = 0;
};

// Values at the lanes of `bits`, 0 elsewhere; nothing else is read.
HWY_INLINE FloatVec loadBits(const float* from, std::uint64_t bits, FloatMask mask) {
  const FloatTag d;
#if HWY_MEM_OPS_MIGHT_FAULT || HWY_TARGET == HWY_SCALAR  // whose masked load reads all the same
  (void)mask;
  HWY_ALIGN float values[kBatchGroup] = {};
  for (; bits != 0; bits &= bits - 1) values[std::countr_zero(bits)] = from[std::countr_zero(bits)];
  return hn::Load(d, values);
#else
  (void)bits;
  return hn::MaskedLoad(mask, d, from);
#endif
}

HWY_INLINE Vec3 pointsAt(const std::array<const float*, 3>& row, int x, std::uint64_t bits) {
  const FloatMask mask = maskOf(FloatTag(), bits);
  return {loadBits(row[0] + x, bits, mask), loadBits(row[1] + x, bits, mask), loadBits(row[2] + x, bits, mask)};
}

// A row and the eight around it.
class RowsAround {
 public:
  RowsAround(const KnownPoints& known, int y, int z) : words_(known.set.words()), unitX_(known.unit.x) {
    const glm::ivec3 size = known.set.size();
    const GridView<const float> view = known.field.component[0].view();
    const std::size_t ahead = view.index(0, std::min(y + kRowsAhead, size.y - 1), std::min(z + 1, size.z - 1));
    for (std::size_t axis = 0; axis < 3; ++axis) ahead_[axis] = known.field.component[axis].data() + ahead;
    for (int dz = -1; dz <= 1; ++dz)
      for (int dy = -1; dy <= 1; ++dy) {
        Row& row = rows_[static_cast<std::size_t>(dy + 1 + 3 * (dz + 1))];
        if (y + dy < 0 || z + dz < 0 || y + dy >= size.y || z + dz >= size.z) continue;
        row.bits = known.set.row(y + dy, z + dz);
        const std::ptrdiff_t at = (static_cast<std::ptrdiff_t>(z + dz) * size.y + (y + dy)) * size.x;
        for (std::size_t axis = 0; axis < 3; ++axis) row.points[axis] = known.field.component[axis].data() + at;
        row.moveY = static_cast<float>(dy) * known.unit.y;
        row.moveZ = static_cast<float>(dz) * known.unit.z;
      }
  }

  // Has a part of a row further on fetched into the caches.
  void prefetch(int x) const {
    for (const float* row : ahead_) hwy::Prefetch(row + x);
  }

  Vec3 ownPoints(const RowPart& part) const { return pointsAt(rows_[kRows / 2].points, part.x, part.bits); }

  // Calls offer(candidates, points, has) for the neighbours at those steps that have points: these as seen from the
  // samples, as seen from themselves, and which they are. `kOften`: most steps have some; then to look whether any has
  // costs more, by wrong guesses of the branch, than to offer none.
  template <bool kOften, class Offer>
  HWY_INLINE void forNeighbours(const RowPart& part, std::span<const Step> steps, const Offer& offer) const {
    const FloatTag d;
    for (const Step step : steps) {
      const Row& row = rows_[static_cast<std::size_t>(step.row)];
      if (row.bits == nullptr) continue;
      const std::uint64_t bits = bitsFrom(row.bits, part.x + step.dx) & part.bits;
      if (!kOften && bits == 0) continue;
      const Vec3 points = pointsAt(row.points, part.x + step.dx, bits);
      const Vec3 candidates = {hn::Add(points.x, hn::Set(d, static_cast<float>(step.dx) * unitX_)),
                               hn::Add(points.y, hn::Set(d, row.moveY)), hn::Add(points.z, hn::Set(d, row.moveZ))};
      offer(candidates, points, maskOf(FloatTag(), bits));
    }
  }

 private:
  struct Row {
    const std::uint64_t* bits = nullptr;  // null beyond the grid
    std::array<const float*, 3> points{};
    float moveY = 0, moveZ = 0;
  };

  // As many bits as a vector has lanes, at least; from >= -1.
  HWY_INLINE std::uint64_t bitsFrom(const std::uint64_t* row, int from) const {
    if (from < 0) return row[0] << 1;
    const auto at = static_cast<unsigned>(from);
    // Four bytes hold the lanes at any shift; at the end of the row they would be of the next one.
    if (at + kFourBytes <= static_cast<unsigned>(words_ * kWordBits)) {
      std::uint32_t bits;
      std::memcpy(&bits, reinterpret_cast<const char*>(row) + at / CHAR_BIT, sizeof bits);
      return bits >> at % CHAR_BIT;
    }
    const unsigned word = at / kWordBits;
    return word >= static_cast<unsigned>(words_) ? 0 : row[word] >> at % kWordBits;
  }

  int words_;
  float unitX_;
  std::array<const float*, 3> ahead_;
  std::array<Row, kRows> rows_;
};

// Calls onPart(part) for parts of a row that hold all samples that are wanted.
template <class OnPart>
HWY_INLINE void forParts(const BitRow& wanted, const OnPart& onPart) {
  const int lanes = static_cast<int>(hn::Lanes(FloatTag()));
  const std::uint64_t all = (std::uint64_t{1} << lanes) - 1;
  for (std::size_t w = 0; w < wanted.size(); ++w)
    for (std::uint64_t left = wanted[w]; left != 0;) {
      const int first = std::countr_zero(left);
      onPart(RowPart{static_cast<int>(w) * kWordBits + first, left >> first & all});
      left &= ~(all << first);
    }
}

// Whole vectors are written, of which what is meant comes first: the batch has room.
HWY_INLINE void append(const RowPart& part, int y, int z, FloatMask which, const Vec3& offset, const Vec3& trial,
                       PointBatch& batch) {
  const FloatTag d;
  const IntTag di;
  const std::size_t at = batch.count;
  const auto put = [&](FloatVec v, PointBatch::Floats& to) { hn::StoreU(hn::Compress(v, which), d, to.data() + at); };
  put(offset.x, batch.offset[0]);
  put(offset.y, batch.offset[1]);
  put(offset.z, batch.offset[2]);
  put(trial.x, batch.trial[0]);
  put(trial.y, batch.trial[1]);
  put(trial.z, batch.trial[2]);
  hn::StoreU(hn::Compress(hn::Iota(di, part.x), hn::RebindMask(di, which)), di, batch.x.data() + at);
  hn::StoreU(hn::Set(di, y), di, batch.y.data() + at);
  hn::StoreU(hn::Set(di, z), di, batch.z.data() + at);
  batch.count += hn::CountTrue(d, which);
}

void startsInRow(const KnownPoints& known, int y, int z, const BitRow& wanted, PointBatch& batch) {
  const FloatTag d;
  const auto zero = hn::Zero(d);
  const RowsAround rows(known, y, z);
  forParts(wanted, [&](const RowPart& part) {
    rows.prefetch(part.x);
    Vec3 best = {hn::Set(d, kUnsetOffset), zero, zero}, normal = {zero, zero, zero};
    const auto none = hn::Set(d, kUnsetOffset * kUnsetOffset);
    auto nearest = none;
    const auto take = [&](const Vec3& candidate, const Vec3& points, FloatMask has) {
      const auto length = dot(candidate, candidate);
      const auto nearer = hn::And(hn::Lt(length, nearest), has);
      best = chosen(nearer, candidate, best);
      normal = chosen(nearer, points, normal);
      nearest = hn::IfThenElse(nearer, length, nearest);
    };
    const auto without = [&] {
      std::uint64_t found = 0;
      std::uint8_t bytes[8] = {};  // as many as StoreMaskBits may write
      hn::StoreMaskBits(d, hn::Lt(nearest, none), bytes);
      std::memcpy(&found, bytes, sizeof found);
      return RowPart{part.x, part.bits & ~found};
    };
    rows.forNeighbours<true>(part, kSteps.along(1), take);
    for (std::size_t axes = 2; axes <= 3; ++axes) {
      const RowPart left = without();
      if (left.bits == 0) break;
      rows.forNeighbours<false>(left, kSteps.along(axes), take);
    }
    const auto squared = dot(normal, normal);
    const auto foot = scaled(normal, hn::Div(dot(best, normal), squared));
    const auto has = hn::Gt(squared, hn::Set(d, kShortestNormal * kShortestNormal));
    append(part, y, z, maskOf(FloatTag(), part.bits), best, chosen(has, foot, best), batch);
  });
}

void nearerInRow(const KnownPoints& known, int y, int z, const BitRow& wanted, float share, PointBatch& batch) {
  const FloatTag d;
  const RowsAround rows(known, y, z);
  forParts(wanted, [&](const RowPart& part) {
    rows.prefetch(part.x);
    Vec3 best = rows.ownPoints(part);
    auto nearest = hn::Mul(dot(best, best), hn::Set(d, share));
    auto taken = hn::Lt(nearest, nearest);
    rows.forNeighbours<true>(part, kSteps.along(1), [&](const Vec3& candidate, const Vec3&, FloatMask has) {
      const auto length = dot(candidate, candidate);
      const auto nearer = hn::And(hn::Lt(length, nearest), has);
      best = chosen(nearer, candidate, best);
      nearest = hn::IfThenElse(nearer, length, nearest);
      taken = hn::Or(taken, nearer);
    });
    if (!hn::AllFalse(d, taken)) append(part, y, z, taken, best, best, batch);
  });
}

void doubtfulInRow(const KnownPoints& known, int y, int z, const BitRow& wanted, PointBatch& batch) {
  const FloatTag d;
  const auto slope = hn::Set(d, static_cast<float>(kSameSheet * kSameSheet));
  const RowsAround rows(known, y, z);
  forParts(wanted, [&](const RowPart& part) {
    rows.prefetch(part.x);
    const Vec3 own = rows.ownPoints(part);
    const auto length = dot(own, own);
    auto other = hn::Lt(length, length);
    rows.forNeighbours<true>(part, kSteps.along(1), [&](const Vec3& there, const Vec3&, FloatMask has) {
      const Vec3 apart = {hn::Sub(there.x, own.x), hn::Sub(there.y, own.y), hn::Sub(there.z, own.z)};
      const auto out = dot(apart, own);
      const auto leaves = hn::Gt(hn::Mul(out, out), hn::Mul(hn::Mul(slope, length), dot(apart, apart)));
      other = hn::Or(other, hn::And(leaves, has));
    });
    if (!hn::AllFalse(d, other)) append(part, y, z, other, own, own, batch);
  });
}

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isolume {

HWY_EXPORT(startsInRow);
HWY_EXPORT(nearerInRow);
HWY_EXPORT(doubtfulInRow);

namespace {

// Room for all samples of a row, so that the kernels need not look.
PointBatch& withRoom(const BitRow& wanted, PointBatch& batch) {
  batch.makeRoom(batch.count + wanted.size() * kWordBits);
  return batch;
}

}  // namespace

void appendStarts(const KnownPoints& known, int y, int z, const BitRow& wanted, PointBatch& batch) {
  HWY_DYNAMIC_DISPATCH(startsInRow)(known, y, z, wanted, withRoom(wanted, batch));
}
void appendNearer(const KnownPoints& known, int y, int z, const BitRow& wanted, float share, PointBatch& batch) {
  HWY_DYNAMIC_DISPATCH(nearerInRow)(known, y, z, wanted, share, withRoom(wanted, batch));
}
void appendDoubtful(const KnownPoints& known, int y, int z, const BitRow& wanted, PointBatch& batch) {
  HWY_DYNAMIC_DISPATCH(doubtfulInRow)(known, y, z, wanted, withRoom(wanted, batch));
}

}  // namespace isolume
#endif
