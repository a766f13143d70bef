// MetaImage (.mhd, .mha): one scalar 3D image (further dimensions of 1 are fine), with its samples in the same file or
// in another one, as they are or compressed. Samples in several files or as text are refused. ITK is not needed, and
// would return arbitrary samples where a file ends too soon.
//
// Voxel (i, j, k) lies at Offset + i s_x a_x + j s_y a_y + k s_z a_z with ElementSpacing s; each consecutive triple of
// TransformMatrix is one axis a. The world is LPS millimetres, as ITK reads it. A negative spacing is a reflection.
#pragma once

#include <string>

#include "volume.h"

namespace isolume {

/// Whether the first bytes of a file look like a MetaImage header.
bool looksLikeMetaImage(const std::string& head);

Volume readMetaImage(const std::string& path);

}  // namespace isolume
