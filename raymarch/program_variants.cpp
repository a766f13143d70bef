#include "program_variants.h"

#include <algorithm>
#include <cassert>

namespace isolume {

const std::vector<ProgramVariant>& programVariants() {
  static const std::vector<ProgramVariant> variants{
      {"beam", "shaders/fullscreen.vert", "shaders/beam.frag"},
      {"march_lights", "shaders/fullscreen.vert", "shaders/march_lights.frag"},
      {"march_local", "shaders/fullscreen.vert", "shaders/march_local.frag"},
      {"march_octants", "shaders/fullscreen.vert", "shaders/march_octants.frag"},
  };
  return variants;
}

const ProgramVariant& programVariant(const std::string& name) {
  const auto& all = programVariants();
  const auto found = std::find_if(all.begin(), all.end(), [&](const ProgramVariant& v) { return v.name == name; });
  assert(found != all.end());
  return *found;
}

}  // namespace isolume
