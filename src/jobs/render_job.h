// `isolume render`: from a volume file to a picture.
#pragma once

#include <glm/vec2.hpp>
#include <optional>
#include <string>

#include "raymarch/renderer.h"
#include "src/io/srgb.h"
#include "src/jobs/camera_choice.h"
#include "src/jobs/color.h"
#include "src/jobs/color_by.h"
#include "src/jobs/light_request.h"
#include "src/jobs/occlusion_method.h"
#include "src/jobs/run_options.h"
#include "src/jobs/screen_request.h"
#include "src/jobs/surface.h"

namespace isolume {

/// Layers of an EXR beside its colour. `all`: every layer that the shading has.
struct Layers {
  bool ambient = false, irradiance = false, normal = false, position = false, depth = false, bent = false,
       thickness = false, all = false;
  bool any() const { return ambient || irradiance || normal || position || depth || bent || thickness || all; }
};

struct RenderJob {
  SurfaceRequest surface;
  std::string output;
  CameraRequest camera;
  glm::ivec2 size{1024, 1024};
  /// One: each costs a pass over the picture, and with four a 256^3 volume at the default size took more than the two
  /// seconds that a whole job may take on two cores.
  int samples = 1;
  OcclusionRequest occlusion;
  ScreenRequest screen;  ///< with an estimator: light from the screen, and `occlusion` says nothing
  LightingRequest light;
  NormalSource normals = NormalSource::data;
  double gamma = 1;
  /// Light grey, so that an open surface stands out from the white page of a figure.
  Color albedo{"#cccccc", glm::vec3(linearFromSrgb(0.8F))};
  ColorRequest color;       ///< with a field: in place of the albedo
  Color background{"white", glm::vec3(1)};
  bool transparent = false;
  Layers layers;
  std::optional<int> bitDepth;  ///< PNG; 8 if not set
  std::string backend = "auto";
  RunOptions run;
};

/// Nothing is written unless all went well. Throws the errors of src/errors.h and GpuError.
void runRenderJob(const RenderJob& request);

}  // namespace isolume
