// Pixels and camera space (shared/screen_block.h), and the frame of a shaded point. Pure functions.
//
// A pixel's ray has camera coordinates (x, y) = centre * pixel * (1 + z * perspective): perspective = 1 / depth of the
// plane, or 0 in an orthographic picture, where all rays are parallel.

vec3 cameraPoint(vec4 picture, vec2 pixel, float depth) {
  float side = picture.z * (1.0f + depth * picture.w);
  return vec3((pixel.x - picture.x) * side, (pixel.y - picture.y) * side, depth);
}

// Change of a pixel's ray with depth.
vec3 cameraRayStep(vec4 picture, vec2 pixel) {
  float side = picture.z * picture.w;
  return vec3((pixel.x - picture.x) * side, (pixel.y - picture.y) * side, 1.0f);
}

// The pixel that a point in front of the eye is seen at; behind the eye there is none.
struct SeenPixel {
  bool found;
  vec2 pixel;
};

const float kNearestToEye = 1e-3f;  // share of the plane's depth

SeenPixel seenPixel(vec4 picture, vec3 point) {
  float scale = 1.0f + point.z * picture.w;
  float perSide = 1.0f / (picture.z * max(scale, kNearestToEye));
  return SeenPixel(scale > kNearestToEye, vec2(picture.x + point.x * perSide, picture.y + point.y * perSide));
}

// Orthonormal axes x, y, z in camera axes.
struct Axes {
  vec3 x;
  vec3 y;
  vec3 z;
};

// The smallest rotation that takes +z to the unit vector `z` (z.z > -1).
Axes axesAlong(vec3 z) {
  float share = 1.0f / (1.0f + z.z);
  float mixed = -z.x * z.y * share;
  return Axes(vec3(1.0f - z.x * z.x * share, mixed, -z.x), vec3(mixed, 1.0f - z.y * z.y * share, -z.y), z);
}

// Axes about a unit normal of any direction: x and y span the tangent plane.
Axes axesAbout(vec3 normal) {
  Axes folded = axesAlong(vec3(normal.x, normal.y, abs(normal.z)));
  float side = normal.z < 0.0f ? -1.0f : 1.0f;
  return Axes(vec3(folded.x.x, folded.x.y, folded.x.z * side), vec3(folded.y.x, folded.y.y, folded.y.z * side), normal);
}

vec3 alongAxes(Axes axes, vec3 v) { return v.x * axes.x + v.y * axes.y + v.z * axes.z; }
vec3 inAxes(Axes axes, vec3 v) { return vec3(dot(v, axes.x), dot(v, axes.y), dot(v, axes.z)); }

// Depth of the tangent plane through the origin above (x, y), in the frame of a shaded point, whose z leads away from the
// eye. Normals across the view or away from the eye stand for planes that rise at most kSteepest.
const float kSteepest = 32.0f;

float tangentDepth(vec3 normal, float x, float y) {
  return (normal.x * x + normal.y * y) / max(-normal.z, 1.0f / kSteepest);
}
