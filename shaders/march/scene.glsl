// What every march shader knows of its scene.
#include "lib/camera_ray.glsl"
#include "lib/cell_cubic.glsl"
#include "lib/clearance.glsl"
#include "lib/ray_box.glsl"
#include "shared/beam_block.h"
#include "shared/clearance_code.h"
#include "shared/frame_uniforms.h"

layout(std140, binding = 0) uniform FrameBlock { FrameUniforms frame; };
layout(location = 0) uniform vec2 pixelOrigin;  // of this tile and sample, relative to the centre of the picture
layout(binding = 0) uniform sampler2DArray levelTexture;
layout(binding = 1) uniform usampler2DArray clearanceTexture;
layout(binding = 2) uniform sampler2DArray distanceTexture;
layout(binding = 7) uniform sampler2D beamTexture;

struct Hit {
  bool found;
  vec3 position;
  int capAxis;     // -1: on the isosurface; else the axis of the face of the box that cuts the solid
};

#include "march/cell.glsl"
#include "march/trace.glsl"
#include "march/normal.glsl"
