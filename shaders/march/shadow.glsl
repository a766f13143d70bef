// Hard shadows: whether a ray from the surface meets the solid, by the walk of trace.glsl.
//
// What the level may be off by at a point of the surface, in units of the largest corner of its cell: three coordinates,
// each rounded twice to half a unit in the last place of the grid's longest side, times slopes of up to 2; and what the
// refinement of the hit leaves. By that much it is taken to be lower on all of the way, so that no ray meets the spot
// that it leaves; nothing is moved, and only what rises by less than this above the surface is missed.
const float kRoundingPerSample = 12.0f * 0.5f * 1.1920929e-7f;
const float kRoundingOfHit = 4.0f * kRefineTolerance;

// 1 where light from that direction arrives at a hit, else 0. `towards` is an index-space vector per smallest spacing,
// as Ray.direction. From behind the surface (N . w <= 0) none does. A hit on a cap leaves the box at once.
float lightVisibility(vec3 hit, vec3 normal, vec3 towards) {
  if (dot(normal, towards * frame.scale.xyz) <= 0.0f) return 0.0f;
  vec3 high = vec3(frame.gridSize.xyz - 1);
  vec3 direction = vec3(awayFromZero(towards.x), awayFromZero(towards.y), awayFromZero(towards.z));
  vec3 inverse = 1.0f / direction;
  if (!(boxSpan(hit, inverse, high).leave > 0.0f)) return 1.0f;
  float rounding = kRoundingPerSample * max(high.x, max(high.y, high.z)) + kRoundingOfHit;
  return firstCrossing(hit, direction, inverse, false, rounding).bracket.found ? 0.0f : 1.0f;
}
