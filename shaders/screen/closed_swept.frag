#version 450 core
// The openness of swept.frag alone.
#include "screen/harness.glsl"
#include "march/light_at.glsl"
#include "screen/swept.glsl"

float estimate(Shaded shaded) {
  SweptPlace at = sweptPlace();
  return lightAt(sweptTextures[0], at.centre, at.layer, at.weight);
}

#include "screen/main.glsl"
