// Everything that ITK can read and the project's own readers do not.
#pragma once

#include <glm/mat4x4.hpp>
#include <optional>
#include <string>

#include "volume.h"

namespace isolume {

/// Whether this build has ITK and ITK recognises the file.
bool itkCanRead(const std::string& path);

/// A scalar 3D image (trailing dimensions of 1 are fine) with its spacing, origin and direction. `feature` names what
/// makes ITK necessary, for the error of a build without it: "NIfTI", "NRRD in encoding 'gzip'", ... `worldFromGrid`,
/// where given, stands for what ITK makes of the header. InputError if the file ends too soon.
Volume readItk(const std::string& path, const std::string& feature,
               const std::optional<glm::dmat4>& worldFromGrid = std::nullopt);

}  // namespace isolume
