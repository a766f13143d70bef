#include "sweep/reference/cell_cubic.h"

#include <algorithm>
#include <cmath>

namespace isolume {
namespace {

// Weights >= 0 keep the signs: a mean of levels <= 0 is <= 0, and u = 0 and u = 1 give the ends themselves.
double mean(double a, double b, double u) { return (1 - u) * a + u * b; }

}  // namespace

CellCorners::CellCorners(GridView<const float> level, glm::ivec3 cell) {
  const float* low = level.data + level.index(cell.x, cell.y, cell.z);
  const float* high = low + level.strideZ();
  const std::ptrdiff_t y = level.strideY();
  at[0] = low[0];
  at[1] = low[1];
  at[2] = low[y];
  at[3] = low[y + 1];
  at[4] = high[0];
  at[5] = high[1];
  at[6] = high[y];
  at[7] = high[y + 1];
}

double CellCorners::valueAt(glm::dvec3 p) const {
  const double low = mean(mean(at[0], at[1], p.x), mean(at[2], at[3], p.x), p.y);
  const double high = mean(mean(at[4], at[5], p.x), mean(at[6], at[7], p.x), p.y);
  return mean(low, high, p.z);
}

glm::dvec3 CellCorners::gradientAt(glm::dvec3 p) const {
  const double x00 = mean(at[0], at[1], p.x), x10 = mean(at[2], at[3], p.x);
  const double x01 = mean(at[4], at[5], p.x), x11 = mean(at[6], at[7], p.x);
  return {mean(mean(at[1] - at[0], at[3] - at[2], p.y), mean(at[5] - at[4], at[7] - at[6], p.y), p.z),
          mean(x10 - x00, x11 - x01, p.z), mean(x01, x11, p.y) - mean(x00, x10, p.y)};
}

Cubic CellCorners::along(glm::dvec3 p, glm::dvec3 q) const {
  double alongX[2][4], alongY[2][2][2];
  for (int i = 0; i < 4; ++i) {
    alongX[0][i] = mean(at[2 * i], at[2 * i + 1], p.x);
    alongX[1][i] = mean(at[2 * i], at[2 * i + 1], q.x);
  }
  for (int x = 0; x < 2; ++x)
    for (int z = 0; z < 2; ++z) {
      alongY[x][0][z] = mean(alongX[x][2 * z], alongX[x][2 * z + 1], p.y);
      alongY[x][1][z] = mean(alongX[x][2 * z], alongX[x][2 * z + 1], q.y);
    }
  const auto value = [&](int x, int y, double z) { return mean(alongY[x][y][0], alongY[x][y][1], z); };
  constexpr double kThird = 1.0 / 3;
  return {value(0, 0, p.z), kThird * ((value(1, 0, p.z) + value(0, 1, p.z)) + value(0, 0, q.z)),
          kThird * ((value(1, 1, p.z) + value(1, 0, q.z)) + value(0, 1, q.z)), value(1, 1, q.z)};
}

double CellCorners::largestMagnitude() const {
  double largest = 0;
  for (const double value : at) largest = std::max(largest, std::abs(value));
  return largest;
}

}  // namespace isolume
