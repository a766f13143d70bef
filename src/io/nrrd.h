// NRRD headers (.nhdr, .nrrd). A detached 3D image in raw encoding is read here; everything else that NRRD knows goes
// to ITK.
//
// Voxel (i, j, k) lies at `space origin` + i d_x + j d_y + k d_z with `space directions` d, or at (i, j, k) * spacings
// where there are none. A declared anatomical space (RAS, LAS, LPS) is converted to LPS, as ITK does, so that every
// reader puts the same image in the same place; other spaces are kept as they are. Volume::world says which it is.
#pragma once

#include <string>

#include "volume.h"

namespace isolume {

bool looksLikeNrrd(const std::string& head);

Volume readNrrd(const std::string& path);

}  // namespace isolume
