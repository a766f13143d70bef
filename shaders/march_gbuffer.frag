#version 450 core
// What the screen-space passes know of the surface: its depth and its normal at the centre of each pixel.
#include "march/scene.glsl"
#include "screen/block.glsl"

layout(location = 0) out float outDepth;    // camera axes, radii; kNothingSeen where nothing is hit
layout(location = 1) out vec4 outNormal;    // grid axes, unit, out of the solid
layout(location = 2) out vec4 outPosition;  // index space; w: 1 where something is hit

void main() {
  Ray ray = cameraRay(frame.planePoint, frame.planeX, frame.planeY, frame.eye, frame.scale,
                      gl_FragCoord.xy + pixelOrigin);
  Hit hit = trace(ray);
  if (!hit.found) {
    outDepth = kNothingSeen;
    outNormal = vec4(0.0f);
    outPosition = vec4(0.0f);
    return;
  }
  outDepth = dot(screen.depthRow.xyz, hit.position - frame.planePoint.xyz);
  outNormal = vec4(surfacePoint(hit, -ray.direction * frame.scale.xyz).normal, 0.0f);
  outPosition = vec4(hit.position, 1.0f);
}
