// The fields that klehm11 reads of the volume, at the hit (src/jobs/screen_light.h): openness, and the components of the
// mean open direction along the grid's axes, where 0 and 1 stand for -1 and 1.
const int kSweptFields = 4;
layout(binding = 9) uniform sampler2DArray sweptTextures[kSweptFields];

// The cell of the hit, and where in it.
struct SweptPlace {
  vec2 centre;
  float layer;
  vec3 weight;
};

SweptPlace sweptPlace() {
  vec3 index = clamp(gridIndex(vec3(0.0f)), vec3(0.0f), vec3(frame.gridSize.xyz - 1));
  vec3 low = min(floor(index), vec3(frame.gridSize.xyz - 2));
  return SweptPlace((low.xy + 1.0f) / vec2(frame.gridSize.xy), low.z, index - low);
}
