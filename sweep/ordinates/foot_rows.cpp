#include "foot_rows.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "surface_feet.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "sweep/ordinates/foot_rows.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef ISOLUME_SWEEP_FOOT_ROWS_ONCE
#define ISOLUME_SWEEP_FOOT_ROWS_ONCE
namespace isolume {

/// Even a corner with no weight counts a little: there may be none but such.
inline constexpr float kLeastCornerWeight = 1e-3F;

}  // namespace isolume
#endif

HWY_BEFORE_NAMESPACE();
namespace isolume::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using FloatTag = hn::CappedTag<float, 16>;
using IntTag = hn::RebindToSigned<FloatTag>;
using FloatVec = hn::Vec<FloatTag>;
using IntVec = hn::Vec<IntTag>;

struct FootVector {
  FloatVec normal[3], position[3];
};

// What is the same for all samples of a row.
class FootReader {
 public:
  FootReader(const FootFields& fields, int y, int z) : size_(fields.level.size), at_(0, y, z) {
    const GridView<const float> level = fields.level;
    const int before[2] = {std::max(y - 1, 0), std::max(z - 1, 0)};
    const int after[2] = {std::min(y + 1, size_.y - 1), std::min(z + 1, size_.z - 1)};
    rows_[0] = &level(0, y, z);
    sides_[0][0] = &level(0, before[0], z);
    sides_[0][1] = &level(0, after[0], z);
    sides_[1][0] = &level(0, y, before[1]);
    sides_[1][1] = &level(0, y, after[1]);
    rows_[1] = &fields.distance(0, y, z);
    const double unit = smallestSpacing(level.spacing);
    unit_ = static_cast<float>(unit);
    farthest_ = static_cast<float>(glm::length(level.spacing) / unit);
    for (int axis = 0; axis < 3; ++axis) perSpacing_[axis] = static_cast<float>(unit / level.spacing[axis]);
    for (int i = 0; i < 2; ++i)
      perStep_[i] = perSpacing_[i + 1] / static_cast<float>(std::max(after[i] - before[i], 1));
  }

  FootVector read(IntVec x) const {
    const FloatTag d;
    const IntTag di;
    // Halves, so that no difference overflows; in units of the smallest spacing.
    const auto half = hn::Set(d, 0.5F);
    const auto fall = [&](const float* from, IntVec before, const float* to, IntVec after) {
      return hn::Sub(hn::Mul(half, hn::GatherIndex(d, from, before)), hn::Mul(half, hn::GatherIndex(d, to, after)));
    };
    const auto before = hn::Max(hn::Sub(x, hn::Set(di, 1)), hn::Zero(di));
    const auto after = hn::Min(hn::Add(x, hn::Set(di, 1)), hn::Set(di, size_.x - 1));
    const auto steps = hn::Max(hn::ConvertTo(d, hn::Sub(after, before)), hn::Set(d, 1.0F));
    FootVector foot;
    foot.normal[0] = hn::Div(hn::Mul(fall(rows_[0], before, rows_[0], after), hn::Set(d, perSpacing_[0])), steps);
    for (std::size_t i = 0; i < 2; ++i)
      foot.normal[i + 1] = hn::Mul(fall(sides_[i][0], x, sides_[i][1], x), hn::Set(d, perStep_[i]));
    FloatVec largest = hn::Zero(d);
    for (const FloatVec& each : foot.normal) largest = hn::Max(largest, hn::Abs(each));
    const auto slopes = hn::Gt(largest, hn::Zero(d));
    const auto divisor = hn::IfThenElse(slopes, largest, hn::Set(d, 1.0F));
    FloatVec squares = hn::Zero(d);
    for (FloatVec& each : foot.normal) {
      each = hn::Div(each, divisor);
      squares = hn::Add(squares, hn::Mul(each, each));
    }
    const auto length = hn::IfThenElse(slopes, hn::Sqrt(squares), hn::Set(d, 1.0F));
    // The sample is next to the surface: farther than a cell's diagonal is a flaw of the distance.
    const auto limit = hn::Set(d, farthest_);
    const auto distance =
        hn::Min(hn::Max(hn::Div(hn::GatherIndex(d, rows_[1], x), hn::Set(d, unit_)), hn::Neg(limit)), limit);
    const FloatVec at[3] = {hn::ConvertTo(d, x), hn::Set(d, static_cast<float>(at_.y)),
                            hn::Set(d, static_cast<float>(at_.z))};
    for (int axis = 0; axis < 3; ++axis) {
      foot.normal[axis] = hn::Div(foot.normal[axis], length);
      const auto step = hn::Mul(hn::Mul(distance, foot.normal[axis]), hn::Set(d, perSpacing_[axis]));
      foot.position[axis] =
          hn::Min(hn::Max(hn::Sub(at[axis], step), hn::Zero(d)), hn::Set(d, static_cast<float>(size_[axis] - 1)));
    }
    return foot;
  }

 private:
  glm::ivec3 size_, at_;
  const float* rows_[2];      // level, distance
  const float* sides_[2][2];  // level before and after along y and z
  float unit_ = 1, farthest_ = 1, perSpacing_[3], perStep_[2];
};

// visit(i, x) for vectors of x; the last is filled up with its last number.
template <class Visit>
void forEachVector(const std::vector<std::int32_t>& x, const Visit& visit) {
  const IntTag di;
  const std::size_t lanes = hn::Lanes(di);
  HWY_ALIGN std::int32_t last[hn::MaxLanes(di)];
  for (std::size_t i = 0; i < x.size(); i += lanes) {
    if (i + lanes <= x.size()) {
      visit(i, hn::LoadU(di, x.data() + i));
      continue;
    }
    for (std::size_t k = 0; k < lanes; ++k) last[k] = x[std::min(i + k, x.size() - 1)];
    visit(i, hn::Load(di, last));
  }
}

void addFeetOnTarget(const FootFields& fields, int y, int z, const std::vector<std::int32_t>& x,
                     std::vector<SurfaceFoot>& feet) {
  const FloatTag d;
  const FootReader reader(fields, y, z);
  const std::size_t first = feet.size();
  feet.resize(first + x.size());
  HWY_ALIGN float numbers[6][hn::MaxLanes(d)];
  forEachVector(x, [&](std::size_t i, IntVec at) {
    const FootVector foot = reader.read(at);
    for (int axis = 0; axis < 3; ++axis) {
      hn::Store(foot.position[axis], d, numbers[axis]);
      hn::Store(foot.normal[axis], d, numbers[3 + axis]);
    }
    for (std::size_t k = 0; k < std::min(hn::Lanes(d), x.size() - i); ++k)
      feet[first + i + k] = {{numbers[0][k], numbers[1][k], numbers[2][k]},
                             {numbers[3][k], numbers[4][k], numbers[5][k]}};
  });
}

// Where in an array of the members of a set the numbers of two neighbours along x stand.
struct PairPlace {
  IntVec number;                  // of the first, or of the next member
  hn::Mask<IntTag> firstIsThere;  // so that the second's number follows
};

// By words of 64 samples: the first is at `bit` of word `word`, whose first member has the number first[word].
PairPlace pairPlace(const std::int32_t* members, const std::int32_t* first, IntVec word, IntVec bit) {
  const IntTag di;
  const hn::RebindToUnsigned<IntTag> du;
  const auto half = hn::Set(di, kWordBits / 2), one = hn::Set(di, 1), halves = hn::Add(word, word);
  const auto low = hn::GatherIndex(di, members, halves), high = hn::GatherIndex(di, members + 1, halves);
  const auto inHigh = hn::Gt(bit, hn::Sub(half, one));
  const auto own = hn::IfThenElse(inHigh, high, low);
  const auto ownBit = hn::Shl(one, hn::And(bit, hn::Sub(half, one)));
  const auto count = [&](IntVec bits) { return hn::BitCast(di, hn::PopulationCount(hn::BitCast(du, bits))); };
  const auto before = hn::Add(count(hn::And(own, hn::Sub(ownBit, one))), hn::IfThenElseZero(inHigh, count(low)));
  return {hn::Add(hn::GatherIndex(di, first, word), before), hn::TestBit(own, ownBit)};
}

void interpolatedRowOnTarget(const FootFields& fields, int y, int z, const std::vector<std::int32_t>& x,
                             const FootValues& from, std::vector<std::int32_t>& interpolated) {
  const FloatTag d;
  const IntTag di;
  const FootReader reader(fields, y, z);
  const glm::ivec3 size = fields.level.size;
  // Rows and layers relative to those of the sample: no offset is too long for a lane.
  const auto* givenRow = reinterpret_cast<const std::int32_t*>(from.given.row(y, z));
  const auto* memberRow = reinterpret_cast<const std::int32_t*>(from.feet.bits().row(y, z));
  const auto* firstRow = reinterpret_cast<const std::int32_t*>(from.feet.firstOf(y, z));
  const auto* values = reinterpret_cast<const std::int32_t*>(from.values);
  const int words = from.given.words(), strides[2] = {words, words * size.y};
  const auto one = hn::Set(d, 1.0F);
  HWY_ALIGN std::int32_t results[hn::MaxLanes(di)];
  forEachVector(x, [&](std::size_t i, IntVec at) {
    const FootVector foot = reader.read(at);
    IntVec low[3];
    FloatVec part[3];
    for (int axis = 0; axis < 3; ++axis) {
      low[axis] = hn::Min(hn::ConvertTo(di, foot.position[axis]), hn::Set(di, size[axis] - 2));
      part[axis] = hn::Sub(foot.position[axis], hn::ConvertTo(d, low[axis]));
    }
    FloatVec sum = hn::Zero(d), weights = hn::Zero(d);
    for (int row = 0; row < 4; ++row) {
      const int sides[2] = {row & 1, row >> 1};
      auto word = hn::ShiftRight<6>(low[0]);
      auto weight = one;
      for (int k = 0; k < 2; ++k) {
        const auto step = hn::Add(hn::Sub(low[k + 1], hn::Set(di, k == 0 ? y : z)), hn::Set(di, sides[k]));
        word = hn::Add(word, hn::Mul(step, hn::Set(di, strides[k])));
        weight = hn::Mul(weight, sides[k] != 0 ? part[k + 1] : hn::Sub(one, part[k + 1]));
      }
      const auto bit = hn::And(low[0], hn::Set(di, kWordBits - 1));
      const PairPlace place = pairPlace(memberRow, firstRow, word, bit);
      // Both samples of the row: two bits, two numbers.
      const auto byte = hn::Add(hn::ShiftLeft<3>(word), hn::ShiftRight<3>(bit));
      const auto bits = hn::Shr(hn::GatherOffset(di, givenRow, byte), hn::And(bit, hn::Set(di, 7)));
      const auto pair = hn::GatherOffset(di, values, hn::Add(place.number, place.number));
      const auto next = hn::And(pair, hn::Set(di, 0xffff)),
                 afterNext = hn::And(hn::ShiftRight<16>(pair), hn::Set(di, 0xffff));
      const IntVec numbers[2] = {next, hn::IfThenElse(place.firstIsThere, afterNext, next)};
      for (int side = 0; side < 2; ++side) {
        const auto share =
            hn::Add(hn::Mul(weight, side != 0 ? part[0] : hn::Sub(one, part[0])), hn::Set(d, kLeastCornerWeight));
        const auto counts = hn::RebindMask(d, hn::TestBit(bits, hn::Set(di, 1 << side)));
        const auto counted = hn::IfThenElseZero(counts, share);
        sum = hn::Add(sum, hn::Mul(counted, hn::ConvertTo(d, numbers[side])));
        weights = hn::Add(weights, counted);
      }
    }
    const auto known = hn::Gt(weights, hn::Zero(d));
    const auto mean = hn::NearestInt(hn::Div(sum, hn::IfThenElse(known, weights, one)));
    hn::Store(hn::IfThenElse(hn::RebindMask(di, known), mean, hn::Set(di, kNoValue)), di, results);
    std::copy_n(results, std::min(hn::Lanes(di), x.size() - i), interpolated.data() + i);
  });
}

}  // namespace isolume::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace isolume {

HWY_EXPORT(addFeetOnTarget);
HWY_EXPORT(interpolatedRowOnTarget);

void addFeet(const FootFields& fields, int y, int z, const std::vector<std::int32_t>& x,
             std::vector<SurfaceFoot>& feet) {
  if (!x.empty()) HWY_DYNAMIC_DISPATCH(addFeetOnTarget)(fields, y, z, x, feet);
}

void interpolatedRow(const FootFields& fields, int y, int z, const std::vector<std::int32_t>& x, const FootValues& from,
                     std::vector<std::int32_t>& interpolated) {
  interpolated.resize(x.size());
  if (!x.empty()) HWY_DYNAMIC_DISPATCH(interpolatedRowOnTarget)(fields, y, z, x, from, interpolated);
}

}  // namespace isolume
#endif
