// Stands in for itk_reader.cpp where the build has no ITK.
#include <fmt/format.h>

#include "errors.h"
#include "itk_reader.h"

namespace isolume {

bool itkCanRead(const std::string&) { return false; }

Volume readItk(const std::string& path, const std::string& feature, const std::optional<glm::dmat4>&) {
  throw InputError(fmt::format("{}: reading {} needs ITK, which this build does not have", path, feature));
}

}  // namespace isolume
