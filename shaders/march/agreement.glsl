// Which samples around a hit belong to its side of the surface (sweep/ordinates/surface_field.h).
const float kLeastAgreement = 0.02f;

// Cosines between the normal and the gradients.
vec4 agreement(vec4 x, vec4 y, vec4 z, vec3 normal) {
  // Slopes may be as large and as small as floats are.
  vec4 largest = max(max(abs(x), abs(y)), abs(z));
  vec4 inverse = 1.0f / clamp(largest, kSmallestLevel, kLargestLevel);
  x *= inverse;
  y *= inverse;
  z *= inverse;
  vec4 along = x * normal.x + y * normal.y + z * normal.z;
  vec4 squares = x * x + y * y + z * z;
  return max(along * inversesqrt(max(squares, vec4(1.0f))), vec4(kLeastAgreement));
}

void weighByAgreement(inout LightPlace place, SurfacePoint point) {
  vec3 size = vec3(frame.gridSize.xyz);
  vec3 low = min(floor(point.position), size - 2.0f);
  // Differences are one-sided at the border.
  vec3 perLow = 1.0f / ((low + 1.0f - max(low - 1.0f, 0.0f)) * frame.scale.xyz);
  vec3 perHigh = 1.0f / ((min(low + 2.0f, size - 1.0f) - low) * frame.scale.xyz);
  vec4 perX = vec4(perLow.x, perHigh.x, perLow.x, perHigh.x);
  vec4 perY = vec4(perLow.y, perLow.y, perHigh.y, perHigh.y);
  float sum = 0.0f;
  for (int z = 0; z < 2; ++z) {
    place.weights[z] *= agreement(point.slopes.x[z] * perX, point.slopes.y[z] * perY,
                                  point.slopes.z[z] * (z == 0 ? perLow.z : perHigh.z), point.normal);
    sum += dot(place.weights[z], vec4(1.0f));
  }
  for (int z = 0; z < 2; ++z) place.weights[z] /= sum;
}
