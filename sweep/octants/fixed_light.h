// Light in 15 bits, and the two loops of its sweep: what the sweep of eight octants for pictures works in
// (fixed_light_sweeper.h).
//
// V is an integer of [0, kFullLight]. What leaves a voxel is kept as N = -V tau, so that a transmittance of exactly 1
// has a 16-bit form, -tau in units of 2^-15. With R(a b) the product of two such numbers, rounded to nearest (ties up),
// and c_x = N_x - (N_z + e), c_y = N_y - (N_z + e), [Singh10] Eq. 6 is
//   V = max(0, -N_z + R(-w_x c_x) + R(-w_y c_y)),  N = R(V (-tau)).
// e is 0, 1, -1 in turn with the steps from voxel to voxel, sign_x x + sign_y y + sign_z z modulo 3: where V varies by
// less than a unit per voxel the same rounding would else be made at every step, and add up. It is left out where a
// weight is 1/2 or more, for there it would not round away in open space. Open space stays full and solid dark,
// exactly. Against the sweep in float: see fixed_light_sweeper.h.
//
// A segment of kSegment steps is passed over where nothing can change in it: where all that flows in is dark, or full
// through clear voxels alone. Both are exact: equal N give c = -e, which rounds away, so that V = -N, and
// R(kFullLight kClear) = -kFullLight. What is handed on then is what came in, and V is one value.
//
// Layout: a column is `lanes` voxels in x by all of y, kFixedPlanes planes. Its vectors are diagonals, so that a sweep
// needs only vectors before: lane j of step t holds y = t - j (rising) or y = t - (lanes - 1 - j) (falling). Rising
// diagonals serve the octants that run up (down) in both x and y, walked forward (backward); falling ones the others.
#pragma once

#include <cstddef>
#include <cstdint>

namespace isolume {

inline constexpr std::int16_t kFullLight = 32767;
/// -tau of a voxel that lets all light pass.
inline constexpr std::int16_t kClear = -32768;
/// Planes of a column that are swept together.
inline constexpr int kFixedPlanes = 2;

/// Columns' width = lanes of 16 bits on this machine.
int columnLanes();

/// Steps of a column, and rows of a plane, that are treated alike where they are even. Shorter ones find more that is
/// even, and take longer to find it.
inline constexpr int kSegment = 16;

/// What a segment holds: `value` everywhere, or several values.
struct Content {
  bool even = false;
  std::int16_t value = 0;
  bool operator==(const Content&) const = default;
};
/// What segments hold that may be of one value together.
inline Content together(Content a, Content b) { return a == b ? a : Content{}; }

/// Lengths of the buffers below, for rows of ny voxels in y.
struct ColumnShape {
  int ny = 0, lanes = 0;
  int steps() const { return ny + lanes - 1; }
  /// Segments of a column's steps; the last may be shorter.
  int segments() const { return (steps() + kSegment - 1) / kSegment; }
  /// Segments of a plane's rows.
  int rowSegments() const { return (ny + kSegment - 1) / kSegment; }
  /// Values of one plane of a column.
  std::size_t plane() const { return static_cast<std::size_t>(steps()) * static_cast<std::size_t>(lanes); }
  std::size_t column() const { return plane() * kFixedPlanes; }
  /// Values of what a plane's last lane hands on, from y = -lanes on; the last segment may be whole.
  std::size_t handover() const { return static_cast<std::size_t>(ny + 2 * lanes + kSegment); }
};

/// What a column keeps of the two octants that share its diagonals: the first stores R((V - zero) factor), the second
/// adds `unit` times its own.
struct LightPart {
  std::int16_t zero = 0, factor = 0, unit = 1;
};
/// round(255 V): of the first octant in the low byte, of the second in the high one.
inline constexpr LightPart kFirstByte{0, 255, 1}, kSecondByte{0, 255, 256};
/// R(share (kFullLight - V)), summed: 0 in the open, exactly. Share in units of 2^-15.
constexpr LightPart missingLight(std::int16_t share) { return {kFullLight, static_cast<std::int16_t>(-share), 1}; }

/// One column of one octant. All [plane][step][lane] but for `edge`; contents [segment], of all planes.
struct FixedColumn {
  const std::int16_t* transmittance = nullptr;  ///< -tau
  const Content* transmittanceContent = nullptr;
  LightPart part;
  std::int16_t* merged = nullptr;     ///< parts, out; read too if walked backward
  Content* mergedContent = nullptr;   ///< in and out as `merged`, whose even segments are left unwritten
  std::int16_t* carried = nullptr;    ///< [step][lane]: N of the plane before, replaced by the last plane's
  Content* carriedContent = nullptr;  ///< as `carried`; even where all is full or dark
  std::int16_t* edge = nullptr;       ///< [plane][y]: N of the column before in x, replaced by this one's
  int phase = 0;                      ///< of e at the first step in the first plane: sign_x x + sign_y y + sign_z z
};

/// Weights of Eq. 6 in units of 2^-15; the third is what they leave of 1.
struct FixedWeights {
  std::int16_t x = 0, y = 0;
};

/// Sweeps two columns side by side: `up` runs up in x, `down` down. `forward`: up in y, `up` in rising diagonals and
/// `down` in falling ones, both the first of their diagonals' octants; else down in y, and all the other way round.
void sweepFixedColumns(const FixedColumn& up, const FixedColumn& down, const ColumnShape& shape, FixedWeights weights,
                       bool forward);

}  // namespace isolume
