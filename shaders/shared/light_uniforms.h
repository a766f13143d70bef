// Lights (raymarch/light_field.h), std140; the same text is a C++ struct in namespace shader.
const int kMostLightFields = 8;
const int kMostSuns = 4;
struct LightUniforms {
  vec4 color[kMostLightFields];  // linear: what a full texel is multiplied with
  vec4 sunColor[kMostSuns];      // linear
  vec4 sun[kMostSuns];           // unit vector towards it, grid axes
  vec4 head;                     // colour of the light from the eye
  vec4 disc[kMostLightFields];   // shadows: unit vector towards the light, grid axes, and its angular radius; else 0
};
