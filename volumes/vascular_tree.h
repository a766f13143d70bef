// A branching vascular tree in the unit cube, grown by space colonisation ([Runions07]): tissue points attract the
// nearest vessel, which grows towards their mean direction, until it is near enough to supply them. Radii obey Murray's
// law, r^3 = sum of the branches' r^3 ([Murray26]), from the capillaries up.
#pragma once

#include <vector>

#include "primitives.h"

namespace isolume {

/// One piece of vessel from each grown node to its parent. Connected: every piece ends where another begins, with the
/// same radius. Deterministic; takes a fraction of a second.
std::vector<TaperedCapsule> growVascularTree();

}  // namespace isolume
