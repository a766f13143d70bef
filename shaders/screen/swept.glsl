// The fields that klehm11 reads of the volume, at the hit (src/jobs/screen_light.h): openness, and the components of the
// mean open direction along the grid's axes, where 0 and 1 stand for -1 and 1.
const int kSweptFields = 4;
layout(binding = 9) uniform sampler2DArray sweptTextures[kSweptFields];

// Of a hit on the border of the grid: of its cap.
LightPlace sweptPlace() {
  const float kBorder = 1e-3f;  // voxels: what positions along a ray are off by
  vec3 last = vec3(frame.gridSize.xyz - 1);
  vec3 index = clamp(gridIndex(vec3(0.0f)), vec3(0.0f), last);
  vec3 away = min(index, last - index);
  int capAxis = -1;
  for (int axis = 0; axis < 3; ++axis)
    if (away[axis] < kBorder) capAxis = axis;
  return lightPlace(index, capAxis, last + 1.0f);
}
