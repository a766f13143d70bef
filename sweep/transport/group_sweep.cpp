#include "group_sweep.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "sweep/large_array.h"

namespace isolume {
namespace {

using Values = LargeArray<std::int16_t>;

constexpr std::int16_t kOutside = -kFullLight;
constexpr float kOne = -static_cast<float>(kClear);
/// Of what a block carries and shows; half of a core's second cache, and less.
constexpr std::size_t kBlockBytes = std::size_t{3} << 18;
constexpr std::array<std::size_t, kBesideCount> kBeside{0, 1, 2, 4, 5, 6};

Values makeValues(std::size_t count, std::int16_t value) {
  Values values = makeLargeArray<std::int16_t>(count);
  std::fill_n(values.get(), count, value);
  return values;
}

int lanesFor(std::size_t ordinates) {
  const int lanes = ordinateLanes();
  return lanes >= kLeastHalved && ordinates <= static_cast<std::size_t>(lanes / 2) ? lanes / 2 : lanes;
}

std::size_t stepValues(int count, int lanes) {
  return static_cast<std::size_t>(stripSteps(count) * kStripRows * lanes);
}

// Numbers of the ordinates of a group, lane by lane.
struct GroupNumbers {
  int lanes;
  Values weights, dither, directions, powers;

  GroupNumbers(const OrdinateGroup& group, const TransportOptions& options, glm::dvec3 spacing)
      : lanes(lanesFor(group.directions.size())),
        weights(makeValues(all(kBesideCount), 0)),
        dither(makeValues(all(1), 0)),
        directions(makeValues(all(3), 0)) {
    const bool byLength = options.transmittance == Transmittance::insideByLength;
    if (byLength) powers = makeValues(all(kPowerSteps + 1), 0);
    for (std::size_t k = 0; k < group.directions.size(); ++k) {
      const UpwindWeights upwind = upwindWeights(options.scheme, group.directions[k], spacing);
      bool dithers = true;
      for (std::size_t i = 0; i < kBesideCount; ++i) {
        const float weight = upwind[kBeside[i]];
        weights[at(i, k)] = static_cast<std::int16_t>(std::lround(-kOne * weight));
        dithers = dithers && weights[at(i, k)] > kClear / 2;
      }
      dither[k] = dithers ? 1 : 0;
      for (int axis = 0; axis < 3; ++axis)
        directions[at(static_cast<std::size_t>(axis), k)] =
            static_cast<std::int16_t>(std::lround(double{kFullLight} * group.directions[k][axis]));
      const float power = powerOf(options.transmittance, group.directions[k]);
      for (std::size_t i = 0; byLength && i <= kPowerSteps; ++i)
        powers[at(i, k)] =
            static_cast<std::int16_t>(std::lround(-kOne * std::pow(static_cast<float>(i) / kPowerSteps, power)));
    }
  }
  std::size_t all(int rows) const { return static_cast<std::size_t>(rows * lanes); }
  std::size_t at(std::size_t row, std::size_t lane) const { return row * static_cast<std::size_t>(lanes) + lane; }
};

class GroupSweep {
 public:
  GroupSweep(const GroupScene& scene, const OrdinateGroup& group)
      : scene_(scene),
        sweep_(group.sweep),
        size_(scene.size),
        strips_((size_.y + kStripRows - 1) / kStripRows),
        numbers_(group, scene.options, scene.spacing),
        lanes_(numbers_.lanes),
        full_(makeValues(static_cast<std::size_t>(lanes_), kFullLight)),
        edgeValues_(static_cast<std::size_t>((size_.x + 2 * (kStripRows - 1)) * lanes_)),
        edges_(makeValues(edgeValues_ * static_cast<std::size_t>(size_.z), kOutside)) {
    ordinates_ = {lanes_, scene.options.scheme != TransportScheme::step, numbers_.weights.get(), numbers_.dither.get(),
                  numbers_.powers.get()};
    const auto strips = static_cast<std::size_t>(scene.blockStrips);
    carried_ = makeValues(strips * stepValues(size_.x, lanes_), kOutside);
    for (Values& plane : visibility_) plane = makeValues(strips * stepValues(size_.x, lanes_), kFullLight);
    if (ordinates_.diagonals) before_ = makeValues(strips * edgeValues_, kOutside);
    // Rows are written in whole vectors.
    const int width = columnLanes();
    rowValues_ = 2 * kRowMargin + (size_.x + width - 1) / width * width;
    rows_ = makeValues(static_cast<std::size_t>((kStripRows + 1) * rowValues_), kClear);
    const std::size_t segments = strips * static_cast<std::size_t>(stripSegments(size_.x));
    carriedContent_.resize(segments);
    for (auto& wanted : wanted_) wanted.resize(segments);
    shown_.resize(segments);
    for (auto& contents : visibilityContent_) contents.assign(segments, {true, kFullLight});
  }

  void sweep(std::int32_t* sums) {
    const int blocks = (strips_ + scene_.blockStrips - 1) / scene_.blockStrips;
    for (int block = 0; block < blocks; ++block) {
      const std::size_t strips = static_cast<std::size_t>(scene_.blockStrips);
      std::fill_n(carried_.get(), strips * stepValues(size_.x, lanes_), kOutside);
      std::fill(carriedContent_.begin(), carriedContent_.end(), Content{true, kOutside});
      if (before_) std::fill_n(before_.get(), strips * edgeValues_, kOutside);
      markWanted(block, -1);
      for (int order = 0; order < size_.z; ++order) {
        markWanted(block, order);
        for (int i = 0; i < scene_.blockStrips && block * scene_.blockStrips + i < strips_; ++i)
          sweepStrip(block, i, order);
        if (order > 0) readPlaces(block, order, sums);
      }
    }
  }

 private:
  int planeOf(int order) const { return sweep_.z > 0 ? order : size_.z - 1 - order; }

  void sweepStrip(int block, int i, int order) {
    const int firstRow = (block * scene_.blockStrips + i) * kStripRows;
    const auto strip = static_cast<std::size_t>(i);
    const std::size_t margin = static_cast<std::size_t>((kStripRows - 1) * lanes_);
    const std::size_t segments = strip * static_cast<std::size_t>(stripSegments(size_.x));
    const std::size_t parity = static_cast<std::size_t>(order % 2);
    LightStrip light{.count = size_.x, .direction = sweep_.x, .phase = firstRow + order};
    for (int r = 0; r < kStripRows; ++r) {
      // Rows beyond the grid are clear: the last of the buffer is.
      const bool exists = firstRow + r < size_.y;
      std::int16_t* row = rows_.get() + (exists ? r : kStripRows) * rowValues_ + kRowMargin;
      const int y = sweep_.y > 0 ? firstRow + r : size_.y - 1 - firstRow - r;
      if (exists) scene_.rows.writeRow(y, planeOf(order), row);
      light.transmittance[static_cast<std::size_t>(r)] = sweep_.x > 0 ? row : row + size_.x - 1;
    }
    light.edge = edges_.get() + static_cast<std::size_t>(order) * edgeValues_ + margin;
    light.before = before_ ? before_.get() + strip * edgeValues_ + margin : light.edge;
    light.carried = carried_.get() + strip * stepValues(size_.x, lanes_);
    light.visibility = visibility_[parity].get() + strip * stepValues(size_.x, lanes_);
    light.carriedContent = carriedContent_.data() + segments;
    light.visibilityContent = visibilityContent_[parity].data() + segments;
    light.wanted = shown_.data() + segments;
    sweepLightStrip(light, ordinates_);
  }

  // The places between the plane and the next one that some ordinate faces, and the segments that they are read in.
  void markWanted(int block, int order) {
    std::swap(wanted_[0], wanted_[1]);
    std::swap(facing_[0], facing_[1]);
    std::vector<std::uint8_t>& wanted = wanted_[1];
    std::fill(wanted.begin(), wanted.end(), std::uint8_t{0});
    facing_[1].clear();
    const int low = sweep_.z > 0 ? order : size_.z - 2 - order;
    if (order < 0 || order + 1 >= size_.z) {
      shown_ = wanted_[0];
      return;
    }
    const StripPlaces& lists = sweep_.y > 0 ? scene_.up : scene_.down;
    for (const NumberedPlace* at = lists.begin(block, low); at != lists.end(block, low); ++at) {
      const FixedPlace& place = at->place;
      if (!faces(place)) continue;
      facing_[1].push_back(at);
      for (int side = 0; side < 2; ++side) {
        const int row = rowIn(block, place.low[1] + side);
        if (!isWithin(row)) continue;
        const std::size_t strip = static_cast<std::size_t>(row / kStripRows * stripSegments(size_.x));
        const int x = sweep_.x > 0 ? place.low[0] : size_.x - 2 - place.low[0], step = x + row % kStripRows;
        wanted[strip + static_cast<std::size_t>(step / kSegment)] = 1;
        wanted[strip + static_cast<std::size_t>((step + 1) / kSegment)] = 1;
      }
    }
    for (std::size_t i = 0; i < shown_.size(); ++i) shown_[i] = wanted_[0][i] | wanted_[1][i];
  }

  // V of all lanes at a sample of a block.
  const std::int16_t* visibilityAt(int x, int row, int order) const {
    const int step = (sweep_.x > 0 ? x : size_.x - 1 - x) + row % kStripRows;
    return visibility_[static_cast<std::size_t>(order % 2)].get() +
           static_cast<std::size_t>(row / kStripRows) * stepValues(size_.x, lanes_) +
           static_cast<std::ptrdiff_t>((step * kStripRows + row % kStripRows) * lanes_);
  }

  bool faces(const FixedPlace& place) const {
    return place.normal[0] * sweep_.x < 0 || place.normal[1] * sweep_.y < 0 || place.normal[2] * sweep_.z < 0;
  }

  // Counted from the first of a block, in the order of the sweep.
  int rowIn(int block, int y) const {
    return (sweep_.y > 0 ? y : size_.y - 1 - y) - block * scene_.blockStrips * kStripRows;
  }
  bool isWithin(int row) const { return row >= 0 && row < scene_.blockStrips * kStripRows; }

  // Those between the plane swept last and the one before.
  void readPlaces(int block, int order, std::int32_t* sums) const {
    const std::array<int, 2> orders = sweep_.z > 0 ? std::array{order - 1, order} : std::array{order, order - 1};
    for (const NumberedPlace* each : facing_[0]) {
      const FixedPlace& place = each->place;
      std::array<const std::int16_t*, 8> corners{};
      for (int side = 0; side < 2; ++side) {
        const int row = rowIn(block, place.low[1] + side);
        for (int corner = 0; corner < 4; ++corner) {
          const int x = corner & 1, z = corner >> 1;
          // Nothing is missing in a row of another block, which adds its own share.
          corners[static_cast<std::size_t>(x + 2 * side + 4 * z)] =
              isWithin(row) ? visibilityAt(place.low[0] + x, row, orders[static_cast<std::size_t>(z)]) : full_.get();
        }
      }
      const PlaceSum sum = readPlace(corners, place, numbers_.directions.get(), lanes_);
      sums[2 * std::size_t{each->number}] += sum.blocked;
      if (isWithin(rowIn(block, place.low[1]))) sums[2 * std::size_t{each->number} + 1] += sum.all;
    }
  }

  const GroupScene& scene_;
  glm::ivec3 sweep_, size_;
  int strips_;
  GroupNumbers numbers_;
  int lanes_, rowValues_ = 0;
  StripOrdinates ordinates_;
  Values full_;
  std::size_t edgeValues_;
  Values edges_;   // of each plane: N of the last row of the block before
  Values before_;  // of each strip: of the row before, in the plane before
  Values carried_, rows_;
  std::array<Values, 2> visibility_;                 // by the planes' order, even and odd
  std::array<std::vector<std::uint8_t>, 2> wanted_;  // of each segment: whether it is read before a plane, and after
  std::vector<std::uint8_t> shown_;                  // whether either
  std::array<std::vector<const NumberedPlace*>, 2> facing_;  // before a plane, and after
  std::vector<Content> carriedContent_;
  std::array<std::vector<Content>, 2> visibilityContent_;
};

}  // namespace

int blockStrips(glm::ivec3 size, int lanes) {
  constexpr std::size_t kPlanes = 3;  // carried, and two of V
  const auto most = static_cast<int>(kBlockBytes / (kPlanes * stepValues(size.x, lanes) * sizeof(std::int16_t)));
  return std::clamp(most, 1, (size.y + kStripRows - 1) / kStripRows);
}

void sweepGroup(const GroupScene& scene, const OrdinateGroup& group, std::int32_t* sums) {
  GroupSweep(scene, group).sweep(sums);
}

}  // namespace isolume
