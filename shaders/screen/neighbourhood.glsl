// The neighbourhood of the shaded point as the G-buffer knows it: answers to what shaded.glsl lets estimators ask.
layout(binding = 0) uniform sampler2D depthTexture;
layout(binding = 1) uniform sampler2D normalTexture;
layout(std140, binding = 2) uniform SampleBlock { ScreenSamples sampleSet; };

// The shaded point of this invocation; set once by main().
struct Place {
  vec3 position;  // camera axes
  Axes axes;      // those of its frame, in camera axes
  vec3 normal;    // in its frame
};
Place place;

int sampleCount() { return screen.size.z; }
vec4 sampleAt(int i) { return sampleSet.samples[i]; }
ivec2 marchCounts() { return screen.march.xy; }
int marchSteps() { return screen.march.z; }
bool normalisedBySamples() { return screen.modes.y != 0; }
bool clampedToTangent() { return screen.modes.z != 0; }
float seenThickness() { return screen.toX.w; }

float depthOf(ivec2 pixel) {
  bool within = all(greaterThanEqual(pixel, ivec2(0))) && all(lessThan(pixel, screen.size.xy));
  return within ? texelFetch(depthTexture, pixel, 0).r : kNothingSeen;
}

// What a pixel shows, in the frame of the shaded point, and how its ray goes there.
struct Seen {
  bool found;
  vec3 point;
  vec3 ray;
};

// At the centre of the pixel that p is seen at. Beyond the picture nothing is known: as if nothing were there.
Seen seenAt(vec3 p) {
  Seen nothing = Seen(false, vec3(p.x, p.y, kNothingSeen), vec3(0.0f, 0.0f, 1.0f));
  SeenPixel seen = seenPixel(screen.picture, place.position + alongAxes(place.axes, p));
  if (!seen.found) return nothing;
  ivec2 pixel = ivec2(floor(seen.pixel));
  float depth = depthOf(pixel);
  if (depth >= kNothingSeen) return nothing;
  vec2 centre = vec2(pixel) + 0.5f;
  return Seen(true, inAxes(place.axes, cameraPoint(screen.picture, centre, depth) - place.position),
              inAxes(place.axes, cameraRayStep(screen.picture, centre)));
}

// Depth of the surface on the line through p along z. The pixel shows a point beside that line: by less than half a pixel,
// and by what its ray leans in perspective. From there the surface is continued along the tangent plane of the shaded
// point, so that a plane is exact at any resolution. The lean counts within the neighbourhood only.
float surfaceDepth(vec3 p) {
  Seen seen = seenAt(p);
  if (!seen.found) return kNothingSeen;
  float shift = (clamp(seen.point.z, -1.0f, 1.0f) - seen.point.z) / seen.ray.z;
  vec2 at = seen.point.xy + shift * seen.ray.xy;
  return seen.point.z + tangentDepth(place.normal, p.x - at.x, p.y - at.y);
}

vec3 seenPoint(vec3 p) { return vec3(p.x, p.y, surfaceDepth(p)); }

const float kFullTurn = 6.283185307f;
// Golden ratio less one: its multiples spread evenly over [0, 1), whatever their number.
const float kGolden = 0.618033989f;
// The same for a second number that does not follow the first: the inverse of the plastic number.
const float kPlastic = 0.754877666f;

// Samples of [Keller01]: each pixel of the pattern turns and shifts the set by its own numbers.
Shaded shadedAt(ivec2 pixel) {
  ivec2 inPattern = pixel % screen.size.w;
  float index = float(inPattern.y * screen.size.w + inPattern.x);
  float angle = kFullTurn * fract(index * kGolden);
  return Shaded(place.normal, vec2(cos(angle), sin(angle)), fract(index * kPlastic));
}

vec3 gridDirection(vec3 v) {
  vec3 camera = alongAxes(place.axes, v);
  return camera.x * screen.toX.xyz + camera.y * screen.toY.xyz + camera.z * screen.toZ.xyz;
}

vec3 cameraFromGrid(vec3 v) { return vec3(dot(screen.toX.xyz, v), dot(screen.toY.xyz, v), dot(screen.toZ.xyz, v)); }

Place placeOf(ivec2 pixel, float depth) {
  vec2 centre = vec2(pixel) + 0.5f;
  vec3 normal = cameraFromGrid(texelFetch(normalTexture, pixel, 0).xyz);
  Axes axes = axesAlong(normalize(cameraRayStep(screen.picture, centre)));
  return Place(cameraPoint(screen.picture, centre, depth), axes, inAxes(axes, normal));
}
