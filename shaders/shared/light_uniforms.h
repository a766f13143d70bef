// The lights that are stored as fields (raymarch/lights.h), std140; the same text is a C++ struct in namespace shader.
const int kMostLightFields = 8;
struct LightUniforms {
  vec4 color[kMostLightFields];  // linear: what a full texel is multiplied with
  vec4 head;                     // colour of the light from the eye
  vec4 disc[kMostLightFields];   // shadows: unit vector towards the light, grid axes, and its angular radius; else 0
};
