#include "program_variants.h"

#include <algorithm>
#include <cassert>

namespace isolume {

const std::vector<ProgramVariant>& programVariants() {
  static const std::vector<ProgramVariant> variants{
      {"beam", "shaders/fullscreen.vert", "shaders/beam.frag"},
      {"march_gbuffer", "shaders/fullscreen.vert", "shaders/march_gbuffer.frag"},
      {"march_lights", "shaders/fullscreen.vert", "shaders/march_lights.frag"},
      {"march_local", "shaders/fullscreen.vert", "shaders/march_local.frag"},
      {"march_octants", "shaders/fullscreen.vert", "shaders/march_octants.frag"},
      {"screen_area", "shaders/fullscreen.vert", "shaders/screen/area.frag"},
      {"screen_bent_ball", "shaders/fullscreen.vert", "shaders/screen/bent_ball.frag"},
      {"screen_bent_disk", "shaders/fullscreen.vert", "shaders/screen/bent_disk.frag"},
      {"screen_bent_hbao", "shaders/fullscreen.vert", "shaders/screen/bent_hbao.frag"},
      {"screen_bent_light", "shaders/fullscreen.vert", "shaders/screen/bent_light.frag"},
      {"screen_bitmask", "shaders/fullscreen.vert", "shaders/screen/bitmask.frag"},
      {"screen_closed_ball", "shaders/fullscreen.vert", "shaders/screen/closed_ball.frag"},
      {"screen_closed_disk", "shaders/fullscreen.vert", "shaders/screen/closed_disk.frag"},
      {"screen_closed_swept", "shaders/fullscreen.vert", "shaders/screen/closed_swept.frag"},
      {"screen_composite", "shaders/fullscreen.vert", "shaders/screen/composite.frag"},
      {"screen_disk", "shaders/fullscreen.vert", "shaders/screen/disk.frag"},
      {"screen_filter", "shaders/fullscreen.vert", "shaders/screen/filter.frag"},
      {"screen_gtao", "shaders/fullscreen.vert", "shaders/screen/gtao.frag"},
      {"screen_hbao", "shaders/fullscreen.vert", "shaders/screen/hbao.frag"},
      {"screen_heights", "shaders/fullscreen.vert", "shaders/screen/heights.frag"},
      {"screen_importance", "shaders/fullscreen.vert", "shaders/screen/importance.frag"},
      {"screen_indirect", "shaders/fullscreen.vert", "shaders/screen/indirect.frag"},
      {"screen_line", "shaders/fullscreen.vert", "shaders/screen/line.frag"},
      {"screen_moments", "shaders/fullscreen.vert", "shaders/screen/moments.frag"},
      {"screen_points", "shaders/fullscreen.vert", "shaders/screen/points.frag"},
      {"screen_ssdo", "shaders/fullscreen.vert", "shaders/screen/ssdo.frag"},
      {"screen_swept", "shaders/fullscreen.vert", "shaders/screen/swept.frag"},
      {"screen_volumetric", "shaders/fullscreen.vert", "shaders/screen/volumetric.frag"},
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
