#include "strip_places.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>

#include "sweep/octants/fixed_light.h"

namespace isolume {
namespace {

std::int16_t fixed(float value) {
  return static_cast<std::int16_t>(std::min(std::lround(value * -static_cast<float>(kClear)), long{kFullLight}));
}

}  // namespace

std::vector<FixedPlace> fixedPlaces(const std::vector<OpenPoint>& points, double offset, glm::ivec3 size) {
  std::vector<FixedPlace> places(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const glm::vec3 above = points[i].position + static_cast<float>(offset) * points[i].normal;
    const glm::vec3 within = glm::clamp(above, glm::vec3(0), glm::vec3(size - 1));
    const glm::ivec3 low = glm::min(glm::ivec3(within), size - 2);
    for (int axis = 0; axis < 3; ++axis) {
      const auto a = static_cast<std::size_t>(axis);
      places[i].low[a] = static_cast<std::int16_t>(low[axis]);
      places[i].part[a] = fixed(within[axis] - static_cast<float>(low[axis]));
      places[i].normal[a] = fixed(points[i].normal[axis]);
    }
  }
  return places;
}

StripPlaces::StripPlaces(const std::vector<FixedPlace>& places, glm::ivec3 size, int blockRows, int sweepY)
    : planes_(size.z - 1) {
  const int blocks = (size.y + blockRows - 1) / blockRows;
  const auto forEachBlock = [&](const FixedPlace& place, const auto& visit) {
    const int y = place.low[1], order = sweepY > 0 ? y : size.y - 2 - y;
    const int first = order / blockRows, last = (order + 1) / blockRows;
    visit(indexOf(first, place.low[2]));
    if (last != first) visit(indexOf(last, place.low[2]));
  };
  first_.assign(indexOf(blocks, 0) + 1, 0);
  for (const FixedPlace& place : places) forEachBlock(place, [&](std::size_t list) { ++first_[list + 1]; });
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  places_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::size_t i = 0; i < places.size(); ++i)
    forEachBlock(places[i], [&](std::size_t list) {
      places_[next[list]++] = {places[i], static_cast<std::uint32_t>(i)};
    });
}

}  // namespace isolume
