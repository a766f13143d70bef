// The characteristic functions of [Szirmay10] Fig. 2: which points lie outside the solid.
//   z-buffer      what is in front of the surface that the picture shows, or its thickness behind it
//   height field  what is above the highest solid of its column, along the grid's z axis
//   implicit      where the level of the volume is not above 0: no blind spots
// The latter two are f > 0 inside, and lines meet f = 0 by a Taylor step from their middle (the paper's text below
// Fig. 2), with the derivative as a difference over kTaylorVoxels to each side.
layout(binding = 3) uniform sampler2DArray levelTexture;
layout(binding = 4) uniform sampler2D heightTexture;

const int kZBuffer = 0;
const int kHeightField = 1;
const int kImplicit = 2;

// Radii: far above rounding, and below what a picture can show.
const float kSurfaceTolerance = 1e-4f;
const float kTaylorVoxels = 0.5f;

// At the border of the grid solids end: outside the box nothing is solid.
bool inGrid(vec3 index) {
  return all(greaterThanEqual(index, vec3(0.0f))) && all(lessThanEqual(index, vec3(frame.gridSize.xyz - 1)));
}

const float kOutsideLevel = -1.0f;

// Trilinear, weighed by hand: filters round their weights to 8 bits.
float volumeLevel(vec3 index) {
  vec3 low = min(floor(index), vec3(frame.gridSize.xyz - 2));
  vec3 weight = index - low;
  vec2 centre = (low.xy + 1.0f) / vec2(frame.gridSize.xy);
  vec4 near = textureGather(levelTexture, vec3(centre, low.z)).wzxy;
  vec4 far = textureGather(levelTexture, vec3(centre, low.z + 1.0f)).wzxy;
  vec4 texels = mix(near, far, weight.z);
  vec2 alongX = mix(texels.xz, texels.yw, weight.x);
  return mix(alongX.x, alongX.y, weight.y);
}

float heightLevel(vec3 index) {
  ivec2 low = min(ivec2(index.xy), frame.gridSize.xy - 2);
  vec2 weight = index.xy - vec2(low);
  float near = mix(texelFetch(heightTexture, low, 0).r, texelFetch(heightTexture, low + ivec2(1, 0), 0).r, weight.x);
  float far = mix(texelFetch(heightTexture, low + ivec2(0, 1), 0).r, texelFetch(heightTexture, low + ivec2(1), 0).r,
                  weight.x);
  return mix(near, far, weight.y) - index.z;
}

vec3 gridIndex(vec3 p) {
  vec3 point = place.position + alongAxes(place.axes, p);
  return frame.planePoint.xyz + point.x * screen.indexX.xyz + point.y * screen.indexY.xyz + point.z * screen.indexZ.xyz;
}

float solidLevel(vec3 p) {
  vec3 index = gridIndex(p);
  if (!inGrid(index)) return kOutsideLevel;
  return screen.modes.x == kImplicit ? volumeLevel(index) : heightLevel(index);
}

float outside(vec3 p) {
  if (screen.modes.x != kZBuffer) return solidLevel(p) > 0.0f ? 0.0f : 1.0f;
  float depth = surfaceDepth(p);
  return p.z <= depth + kSurfaceTolerance || p.z > depth + seenThickness() ? 1.0f : 0.0f;
}

// A function that falls along the line ends the solid there: the part outside is the far one.
OuterParts levelParts(vec2 at, float near, float far) {
  float middle = 0.5f * (near + far);
  float reach = min(kTaylorVoxels / screen.toZ.w, 0.5f * (far - near));
  float before = solidLevel(vec3(at, middle - reach));
  float after = solidLevel(vec3(at, middle + reach));
  float value = 0.5f * (before + after);
  float slope = after - before;
  // No slope: the whole line is on one side.
  float crossing = slope == 0.0f ? (value > 0.0f ? near : far) : middle - 2.0f * reach * value / slope;
  float depth = clamp(crossing, near, far);
  return slope < 0.0f ? OuterParts(vec2(near, near), vec2(depth, far)) : OuterParts(vec2(near, depth), vec2(far, far));
}

OuterParts outerParts(vec2 at, float near, float far) {
  if (screen.modes.x != kZBuffer) return levelParts(at, near, far);
  return partsAround(surfaceDepth(vec3(at, 0.5f * (near + far))), seenThickness(), near, far);
}
