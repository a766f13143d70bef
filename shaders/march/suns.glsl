// Suns whose shadows are found along rays of their own; raymarch/lights.h leaves them out where there are none.
#include "march/shadow.glsl"

vec3 sunLight(LightUniforms lights, vec3 hit, vec3 normal) {
  vec3 sum = vec3(0.0f);
  for (int i = 0; i < kSuns; ++i) {
    vec3 sun = lights.sun[i].xyz;
    float cosine = max(dot(normal, sun), 0.0f);
    sum += cosine * lightVisibility(hit, normal, sun / frame.scale.xyz) * lights.sunColor[i].rgb;
  }
  return sum;
}
