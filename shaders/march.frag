#version 450 core
// One pixel: the first crossing of the isosurface along its ray, and its shade. All in index space, where sample
// (i, j, k) lies at (i, j, k), the solid is { level > 0 } in the box [0, size - 1], and nothing lies outside the box.
#include "lib/ambient.glsl"
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
layout(binding = 3) uniform sampler3D octants0Texture;
layout(binding = 4) uniform sampler3D octants1Texture;
layout(binding = 5) uniform sampler2D geometry0Texture;
layout(binding = 6) uniform sampler2D geometry1Texture;
layout(binding = 7) uniform sampler2D beamTexture;

layout(location = 0) out vec4 outColor;     // linear, premultiplied
layout(location = 1) out vec4 outNormal;    // grid axes, unit, out of the solid; w: ambient
layout(location = 2) out vec4 outPosition;  // index space; w: 1 where something is hit

struct Hit {
  bool found;
  vec3 position;
  int capAxis;     // -1: on the isosurface; else the axis of the face of the box that cuts the solid
};

#include "march/cell.glsl"
#include "march/trace.glsl"
#include "march/shade.glsl"

void main() {
  Ray ray = cameraRay(frame.planePoint, frame.planeX, frame.planeY, frame.eye, frame.scale,
                      gl_FragCoord.xy + pixelOrigin);
  Hit hit = trace(ray);
  if (!hit.found) {
    outColor = frame.background;
    outNormal = vec4(0.0f, 0.0f, 0.0f, 1.0f);
    outPosition = vec4(0.0f);
    return;
  }
  vec3 viewer = -ray.direction * frame.scale.xyz;
  vec3 normal = hitNormal(hit, viewer);
  float ambient = frame.gridSize.w != 0 ? hitAmbient(hit.position, normal) : 1.0f;
  float light = frame.modes.x == 0 ? ambient : abs(dot(normal, viewer));
  outColor = vec4(frame.albedo.rgb * pow(light, frame.albedo.w), 1.0f);
  outNormal = vec4(normal, ambient);
  outPosition = vec4(hit.position, 1.0f);
}
