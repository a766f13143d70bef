// One pixel: the first crossing of the isosurface along its ray, and its shade by the entry's hitLight(). All in index
// space, where sample (i, j, k) lies at (i, j, k), the solid is { level > 0 } in the box [0, size - 1], and nothing lies
// outside the box.
#include "march/albedo.glsl"

layout(location = 0) out vec4 outColor;     // linear, premultiplied
layout(location = 1) out vec4 outNormal;    // grid axes, unit, out of the solid
layout(location = 2) out vec4 outPosition;  // index space; w: 1 where something is hit
layout(location = 3) out vec4 outLight;     // linear, before albedo and gamma

void main() {
  Ray ray = cameraRay(frame.planePoint, frame.planeX, frame.planeY, frame.eye, frame.scale,
                      gl_FragCoord.xy + pixelOrigin);
  Hit hit = trace(ray);
  if (!hit.found) {
    outColor = frame.background;
    outNormal = vec4(0.0f);
    outPosition = vec4(0.0f);
    outLight = vec4(1.0f);
    return;
  }
  vec3 viewer = -ray.direction * frame.scale.xyz;
  SurfacePoint point = surfacePoint(hit, viewer);
  vec3 light = hitLight(point, viewer);
  outColor = vec4(albedoAt(hit.position) * pow(light, vec3(frame.albedo.w)), 1.0f);
  outNormal = vec4(point.normal, 0.0f);
  outPosition = vec4(hit.position, 1.0f);
  outLight = vec4(light, 1.0f);
}
