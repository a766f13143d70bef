// What lines through the ball have in common: their ends, and what their sum is divided by. `scale` is the radius of the
// ball in radii.

// The line of a sample at `at`, of half length `reach`: z of its ends; clamped, what lies above the tangent plane
// ([Loos10] Sec. 4.4).
vec2 ballLine(Shaded shaded, vec2 at, float reach) {
  if (!clampedToTangent()) return vec2(-reach, reach);
  return aboveTangent(shaded.normal, tangentDepth(shaded.normal, at.x, at.y), -reach, reach);
}

// `open` over the ball, or its half, or over the `whole` of the same lines in the open.
float shareOfBall(float open, float whole, float scale) {
  float ball = clampedToTangent() ? 0.5f * scale : scale;
  float divisor = normalisedBySamples() ? whole : ball;
  return divisor > 0.0f ? clamp(open / divisor, 0.0f, 1.0f) : 1.0f;
}
