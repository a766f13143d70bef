#version 450 core
// The openness of swept.frag alone.
#include "screen/harness.glsl"
#include "march/light_at.glsl"
#include "screen/swept.glsl"

float estimate(Shaded shaded) {
  return lightAt(sweptTextures[0], sweptPlace());
}

#include "screen/main.glsl"
