// Reading fields of light, padded by a layer of caps (sweep/ordinates/surface_field.h), at a point of the surface.

// Four texels of two slices each around `centre`, from slice `layer` on, and what each counts.
struct LightPlace {
  vec2 centre;
  float layer;
  vec4 weights[2];  // x fastest, then y; of each slice
};

// `capAxis`: -1 on the isosurface. Trilinear, weighed by hand: filters round their weights to 8 bits. All corners of a
// cell that the isosurface crosses hold a value, and so do all solid samples of a face and those beside them.
LightPlace lightPlace(vec3 position, int capAxis, vec3 gridSize) {
  vec3 padded = position + 1.0f;
  if (capAxis >= 0) padded[capAxis] = position[capAxis] > 0.5f ? gridSize[capAxis] + 1.0f : 0.0f;
  vec3 low = min(floor(padded), gridSize);
  vec3 part = padded - low;
  vec4 layer = vec4(1.0f - part.x, part.x, 1.0f - part.x, part.x) *
               vec4(1.0f - part.y, 1.0f - part.y, part.y, part.y);
  return LightPlace((low.xy + 1.0f) / (gridSize.xy + 2.0f), low.z, vec4[2](layer * (1.0f - part.z), layer * part.z));
}

// At most 1, whatever the rounding of the weights.
float lightAt(sampler2DArray field, LightPlace place) {
  vec4 low = textureGather(field, vec3(place.centre, place.layer)).wzxy;
  vec4 high = textureGather(field, vec3(place.centre, place.layer + 1.0f)).wzxy;
  return min(dot(low, place.weights[0]) + dot(high, place.weights[1]), 1.0f);
}
