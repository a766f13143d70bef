#include "fixed_transport.h"

#include <cassert>

#include "group_sweep.h"
#include "sweep/ordinates/foot_sums.h"

namespace isolume {
namespace {

TransmittanceRamp fixedRamp(Transmittance model) {
  if (model == Transmittance::centred) return centredRamp(1);
  return {.slope = 1, .middle = 1, .least = 0};
}

}  // namespace

std::vector<float> transportBlocked(GridView<const float> distance, const std::vector<OpenPoint>& points,
                                    const TransportOptions& options) {
  assert(options.ordinates >= 1 && distance.size.x >= 2 && distance.size.y >= 2 && distance.size.z >= 2);
  const int lanes = ordinateLanes(), strips = blockStrips(distance.size, lanes);
  const std::vector<FixedPlace> places = fixedPlaces(points, options.offsetVoxels, distance.size);
  const StripPlaces up(places, distance.size, strips * kStripRows, 1);
  const StripPlaces down(places, distance.size, strips * kStripRows, -1);
  const RowContents rows(distance, fixedRamp(options.transmittance));
  const GroupScene scene{distance.size, distance.spacing, options, rows, up, down, strips};
  const std::vector<OrdinateGroup> groups = ordinateGroups(options.ordinates, lanes);
  FootSums sums(2 * points.size());
  parallelFor(groups.size(), [&](std::size_t i) {
    std::vector<std::int32_t> own = sums.take();
    sweepGroup(scene, groups[i], own.data());
    sums.giveBack(std::move(own));
  });
  std::vector<float> blocked(points.size());
  forEachFoot(points.size(), [&](std::size_t i) {
    const std::int32_t missing = sums.takeTotal(2 * i), all = sums.takeTotal(2 * i + 1);
    blocked[i] = all == 0 ? 0 : static_cast<float>(static_cast<double>(missing) / static_cast<double>(all));
  });
  return blocked;
}

}  // namespace isolume
