// Reading cells: their clearance and their corners.

bool mayHoldSurface(uint clearance) { return (clearance & kClearanceRadiusMask) == 0u; }
bool isInside(uint clearance) { return (clearance & kClearanceInside) != 0u; }
int clearRadius(uint clearance) { return max(int(clearance & kClearanceRadiusMask), 1); }

uint cellClearance(ivec3 cell) { return texelFetch(clearanceTexture, cell, 0).r; }

// Magnitudes between these are scaled to 1. Their inverses are neither infinite nor denormal, which GPUs flush to 0.
const float kSmallestLevel = 1e-37f;
const float kLargestLevel = 1e37f;

// The level along the ray in a cell, as a polynomial in t - start, scaled so that the largest corner is about 1
// (levels near the end of float would overflow), and times `side`.
Cubic levelAlongRay(ivec3 cell, vec3 origin, vec3 direction, float start, float side) {
  vec2 between = (vec2(cell.xy) + 1.0f) / vec2(frame.gridSize.xy);  // the corner that the four texels share
  vec4 low = textureGather(levelTexture, vec3(between, float(cell.z))).wzxy;
  vec4 high = textureGather(levelTexture, vec3(between, float(cell.z + 1))).wzxy;
  vec4 largest4 = max(abs(low), abs(high));
  float largest = max(max(largest4.x, largest4.y), max(largest4.z, largest4.w));
  float normalise = side / clamp(largest, kSmallestLevel, kLargestLevel);
  vec3 entry = clamp(origin + start * direction - vec3(cell), 0.0f, 1.0f);
  return cellCubic(low * normalise, high * normalise, entry, direction);
}
