// What an estimator is asked about, and what it may ask in turn. Each estimator is one function from a Shaded to an
// openness in [0, 1]. Lengths are in radii; the frame is that of the shaded point: the origin, with z along its pixel's
// ray away from the eye. The includer provides
//   int sampleCount(), vec4 sampleAt(int)  the set of samples; what its members mean is up to the estimator
//   ivec2 marchCounts()                    directions around the point, and steps along each
//   int marchSteps()                       further points on the way to a sample; for march_to.glsl alone
//   vec3 gridDirection(vec3 v)             from this frame to the axes of the grid, which the G-buffer's normals have
//   bool normalisedBySamples()             whether a sum is divided by what the same samples give in the open
//   bool clampedToTangent()                whether what lies behind the tangent plane is left out
//   float outside(vec3 p)                  the characteristic function: 1 outside the solid, 0 inside
//   OuterParts outerParts(vec2 at, float near, float far)   the part outside of a line along z
//   float seenThickness()                  how far what is seen reaches behind its front
//   DepthSpread depthSpread(vec2 at, float share)  of the depths in a circle about `at` with that share of the unit
//                                          disk's area; for area.glsl alone
//   vec3 seenPoint(vec3 p)                 the point of the surface on the line through p along z, or one far behind p
//                                          if there is none
struct Shaded {
  vec3 normal;   // unit, out of the solid
  vec2 turn;     // cosine and sine of the angle that this pixel's samples are turned by
  float jitter;  // [0, 1): how far this pixel's marches are shifted, in steps
};

// Parts [x, y] of a line that lie outside: in front of the surface, and behind it where it has a thickness.
struct OuterParts {
  vec2 front;
  vec2 back;
};

// Mean and standard deviation of depths.
struct DepthSpread {
  float mean;
  float deviation;
};

vec2 turnedBy(vec2 turn, float x, float y) { return vec2(turn.x * x - turn.y * y, turn.y * x + turn.x * y); }

float outerLength(OuterParts parts) { return parts.front.y - parts.front.x + parts.back.y - parts.back.x; }

// What a surface at `depth` leaves of the line [near, far]: all in front of it, and what lies `thickness` behind it.
OuterParts partsAround(float depth, float thickness, float near, float far) {
  return OuterParts(vec2(near, clamp(depth, near, far)), vec2(clamp(depth + thickness, near, far), far));
}

// The part of the line [near, far] on the open side of the tangent plane, `plane` being its depth there.
vec2 aboveTangent(vec3 normal, float plane, float near, float far) {
  float cut = clamp(plane, near, far);
  return normal.z > 0.0f ? vec2(cut, far) : vec2(near, cut);
}
