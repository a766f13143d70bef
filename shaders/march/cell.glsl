// Reading cells: their clearance and their corners.

// Where the clearance of the cells of a walk stands in its texture: coordinates = shift + scale * cell.
struct ClearanceMap {
  vec3 scale;
  vec3 shift;
};

ClearanceMap clearanceMap(Walk walk) {
  vec3 texel = vec3(1.0f / vec2(frame.gridSize.xy - 1), 1.0f);
  return ClearanceMap(walk.turn * texel, (walk.base + vec3(0.5f, 0.5f, 0.0f)) * texel);
}

// By a filter that is set to nearest: a third of what texelFetch costs llvmpipe.
uint cellClearance(ClearanceMap map, vec3 cell) {
  return textureLod(clearanceTexture, map.shift + map.scale * cell, 0.0f).r;
}

// Magnitudes between these are scaled to 1. Their inverses are neither infinite nor denormal, which GPUs flush to 0.
const float kSmallestLevel = 1e-37f;
const float kLargestLevel = 1e37f;

// The level along the ray in a cell of the grid, as a polynomial in t - start, scaled so that the largest corner is about
// 1 (levels near the end of float would overflow).
Cubic levelAlongRay(vec3 cell, vec3 origin, vec3 direction, float start) {
  vec2 between = (cell.xy + 1.0f) / vec2(frame.gridSize.xy);  // the corner that the four texels share
  vec4 low = textureGather(levelTexture, vec3(between, cell.z)).wzxy;
  vec4 high = textureGather(levelTexture, vec3(between, cell.z + 1.0f)).wzxy;
  vec4 largest4 = max(abs(low), abs(high));
  float largest = max(max(largest4.x, largest4.y), max(largest4.z, largest4.w));
  float normalise = 1.0f / clamp(largest, kSmallestLevel, kLargestLevel);
  vec3 entry = clamp(origin + start * direction - cell, 0.0f, 1.0f);
  return cellCubic(low * normalise, high * normalise, entry, direction);
}
