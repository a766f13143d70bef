#version 450 core
// One beam per block of pixels: how far all its rays may go before one of them can meet anything.
//
// A beam leaps through cubes of cells that the clearance texture certifies to be free of surface, as long as all its rays
// are within. What lies outside the grid is free as well. The march starts each ray where its beam stopped, and does not
// draw blocks whose beam passed the whole grid: in a 1024^2 picture of a 256^3 grid that saves half the frame's time.
#include "lib/beam.glsl"
#include "shared/beam_block.h"
#include "shared/clearance_code.h"
#include "shared/frame_uniforms.h"

layout(std140, binding = 0) uniform FrameBlock { FrameUniforms frame; };
layout(location = 0) uniform vec2 pixelOrigin;  // of this tile, relative to the centre of the picture
layout(binding = 1) uniform usampler2DArray clearanceTexture;

layout(location = 0) out float outStart;  // s of lib/beam.glsl, or kBeamMissed

// Anti-aliasing moves the rays of a pixel by up to half a pixel.
const float kHalfBlock = 0.5f * float(kBeamBlock) + 0.5f;
// What float may be off, in voxels, relative to the grid's longest side: points are at most a few sides from 0.
const float kRounding = 2e-6f;
// Voxels. A beam that gains less per leap than this is as wide as the clearance around it.
const float kSmallestLeap = 0.05f;

float beamStart() {
  vec2 pixel = gl_FragCoord.xy * float(kBeamBlock) + pixelOrigin;
  vec3 centre = frame.planePoint.xyz + (frame.planeX.xyz * pixel.x + frame.planeY.xyz * pixel.y);
  vec3 along = frame.eye.w * centre - frame.eye.xyz;
  vec3 reach = kHalfBlock * (abs(frame.planeX.xyz) + abs(frame.planeY.xyz));
  vec3 high = vec3(frame.gridSize.xyz - 1);
  ivec3 lastCell = frame.gridSize.xyz - 2;
  Beam beam = makeBeam(centre, along, reach, frame.eye.w, kRounding * max(high.x, max(high.y, high.z)));

  float eye = frame.eye.w > 0.0f ? -1.0f : -frame.planePoint.w / length(along * frame.scale.xyz);
  float s = beamEnters(beam, high, eye);
  float last = beamPasses(beam, high);
  float leap = kSmallestLeap / length(along);
  while (s < last) {
    ivec3 cell = clamp(ivec3(floor(centre + s * along)), ivec3(0), lastCell);
    uint clearance = texelFetch(clearanceTexture, cell, 0).r;
    int radius = int(clearance & kClearanceRadiusMask);
    if (radius == 0 || (clearance & kClearanceInside) != 0u) return s;
    ivec3 lowCell = cell - (radius - 1);
    ivec3 highCell = cell + (radius - 1);
    vec3 low = mix(vec3(lowCell), vec3(-kBeamFar), lessThanEqual(lowCell, ivec3(0)));
    vec3 top = mix(vec3(highCell + 1), vec3(kBeamFar), greaterThanEqual(highCell, lastCell));
    float next = beamStaysWithin(beam, low, top, s);
    if (!(next > s + leap)) return s;
    s = next;
  }
  return kBeamMissed;
}

void main() { outStart = beamStart(); }
