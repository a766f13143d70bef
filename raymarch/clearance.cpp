#include "clearance.h"

#include <algorithm>

#include "sweep/parallel.h"

namespace isolume {
namespace shader {
using uint = unsigned int;
#include "shaders/shared/clearance_code.h"
}  // namespace shader

namespace {

using Byte = std::uint8_t;
constexpr Byte kLargest = shader::kClearanceRadiusMask;

// Cells of an x-row between four rows of samples: 0 where mixed, else the largest radius.
void markRow(const float* const level[4], int cells, Byte* out) {
  const float *l0 = level[0], *l1 = level[1], *l2 = level[2], *l3 = level[3];
  for (int x = 0; x < cells; ++x) {
    const int inside = (l0[x] > 0) + (l1[x] > 0) + (l2[x] > 0) + (l3[x] > 0) + (l0[x + 1] > 0) + (l1[x + 1] > 0) +
                       (l2[x + 1] > 0) + (l3[x + 1] > 0);
    out[x] = inside == 0 || inside == 8 ? kLargest : Byte{0};
  }
}

Byte oneMore(Byte value) { return static_cast<Byte>(std::min<int>(value + 1, kLargest)); }

void spreadAlongRow(Byte* row, int cells) {
  for (int x = 1; x < cells; ++x) row[x] = std::min(row[x], oneMore(row[x - 1]));
  for (int x = cells - 2; x >= 0; --x) row[x] = std::min(row[x], oneMore(row[x + 1]));
}

// row = min(row, 1 + the smallest of three neighbours of `from`).
void spreadFromRow(const Byte* from, int cells, Byte* row) {
  const auto take = [&](int x, Byte smallest) { row[x] = std::min(row[x], oneMore(smallest)); };
  if (cells == 1) return take(0, from[0]);
  take(0, std::min(from[0], from[1]));
  for (int x = 1; x < cells - 1; ++x) take(x, std::min(from[x], std::min(from[x - 1], from[x + 1])));
  take(cells - 1, std::min(from[cells - 2], from[cells - 1]));
}

struct Cells {
  Byte* data;
  glm::ivec3 size;
  Byte* row(int y, int z) const {
    return data + (static_cast<std::size_t>(z) * static_cast<std::size_t>(size.y) + static_cast<std::size_t>(y)) *
                      static_cast<std::size_t>(size.x);
  }
};

// Distances within one plane.
void spreadInPlane(const Cells& cells, int z) {
  for (int y = 0; y < cells.size.y; ++y) spreadAlongRow(cells.row(y, z), cells.size.x);
  for (int y = 1; y < cells.size.y; ++y) spreadFromRow(cells.row(y - 1, z), cells.size.x, cells.row(y, z));
  for (int y = cells.size.y - 2; y >= 0; --y) spreadFromRow(cells.row(y + 1, z), cells.size.x, cells.row(y, z));
}

// One plane from the one before it, rows [begin, end).
void spreadFromPlane(const Cells& cells, int from, int z, int begin, int end) {
  std::vector<Byte> smallest(static_cast<std::size_t>(cells.size.x));
  for (int y = begin; y < end; ++y) {
    const Byte* low = cells.row(std::max(y - 1, 0), from);
    const Byte* middle = cells.row(y, from);
    const Byte* high = cells.row(std::min(y + 1, cells.size.y - 1), from);
    for (int x = 0; x < cells.size.x; ++x) {
      smallest[static_cast<std::size_t>(x)] = std::min(middle[x], std::min(low[x], high[x]));
    }
    spreadFromRow(smallest.data(), cells.size.x, cells.row(y, z));
  }
}

void spreadAlongZ(const Cells& cells) {
  constexpr int kRowsPerTask = 64;
  const auto tasks = static_cast<std::size_t>((cells.size.y + kRowsPerTask - 1) / kRowsPerTask);
  const auto step = [&](int from, int z) {
    parallelFor(tasks, [&](std::size_t task) {
      const int begin = static_cast<int>(task) * kRowsPerTask;
      spreadFromPlane(cells, from, z, begin, std::min(begin + kRowsPerTask, cells.size.y));
    });
  };
  for (int z = 1; z < cells.size.z; ++z) step(z - 1, z);
  for (int z = cells.size.z - 2; z >= 0; --z) step(z + 1, z);
}

}  // namespace

std::vector<std::uint8_t> buildClearance(GridView<const float> level) {
  std::vector<std::uint8_t> out(voxelCount(level.size - 1));
  const Cells cells{out.data(), level.size - 1};
  parallelFor(static_cast<std::size_t>(cells.size.z), [&](std::size_t plane) {
    const int z = static_cast<int>(plane);
    for (int y = 0; y < cells.size.y; ++y) {
      const float* rows[4];
      for (int corner = 0; corner < 4; ++corner) {
        rows[corner] = level.data + level.index(0, y + (corner & 1), z + corner / 2);
      }
      markRow(rows, cells.size.x, cells.row(y, z));
    }
    spreadInPlane(cells, z);
  });
  spreadAlongZ(cells);
  parallelFor(static_cast<std::size_t>(cells.size.z), [&](std::size_t plane) {
    const int z = static_cast<int>(plane);
    for (int y = 0; y < cells.size.y; ++y) {
      const float* corners = level.data + level.index(0, y, z);
      Byte* row = cells.row(y, z);
      for (int x = 0; x < cells.size.x; ++x) {
        const Byte side = corners[x] > 0 ? shader::kClearanceInside : Byte{0};
        row[x] = row[x] == 0 ? Byte{0} : static_cast<Byte>(row[x] | side);
      }
    }
  });
  return out;
}

}  // namespace isolume
