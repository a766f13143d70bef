// The colour of the surface that a pixel shows, by the field at its hit.
#include "march/albedo_field.glsl"

layout(binding = 18) uniform sampler2D positionTexture;  // index space

vec3 albedoOf(ivec2 pixel) { return albedoAt(texelFetch(positionTexture, pixel, 0).xyz); }
