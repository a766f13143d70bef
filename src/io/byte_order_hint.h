// Whether raw samples look as if they were read in the wrong byte order: a hint for the user, never acted upon.
#pragma once

#include <string>

#include "raw_samples.h"

namespace isolume {

/// A line for Volume::notes where neighbours along x in the middle of the file would be at least four times closer to
/// each other, measured against their range, in the other byte order; "" otherwise. Reads a few KiB.
std::string byteOrderHint(const RawDescription& description);

}  // namespace isolume
