// Visibility bitmask ([Therrien23]): a slice as in gtao.glsl, but in place of two horizons one bit for each of 32 sectors
// of equal light. What is seen closes the sectors from its front to its back, `thickness` behind it, so that light
// passes behind thin things.

// Where the angle h stands in the light of a slice: 0 at one end of the open half circle, 1 at the other.
float sectorPlace(float normal, float h) {
  float low = normal - kQuarterTurn;
  float bounded = clamp(h, low, normal + kQuarterTurn);
  float before = sliceLight(normal, low);
  float light = sliceLight(normal, bounded);
  return (bounded < 0.0f ? before - light : before + light) / openSliceLight(normal);
}

// Sectors [first, last) as bits.
const float kSectors = 32.0f;

uint sectorsBelow(int last) { return last >= int(kSectors) ? ~0u : (1u << uint(last)) - 1u; }

uint sectorsBetween(float a, float b) {
  int first = int(floor(min(a, b) * kSectors + 0.5f));
  int last = int(floor(max(a, b) * kSectors + 0.5f));
  return sectorsBelow(last) & ~sectorsBelow(first);
}

uint closedSectors(Shaded shaded, Slice slice, float side, int steps) {
  uint closed = 0u;
  for (int j = 0; j < steps; ++j) {
    vec3 seen = sliceStep(shaded, slice, side, j, steps);
    if (occludes(seen)) {
      vec3 behind = vec3(seen.x, seen.y, seen.z + seenThickness());
      closed |= sectorsBetween(sectorPlace(slice.normal, side * angleFromEye(seen)),
                               sectorPlace(slice.normal, side * angleFromEye(behind)));
    }
  }
  return closed;
}

float bitmaskOpenness(Shaded shaded) {
  ivec2 counts = marchCounts();
  float open = 0.0f;
  float whole = 0.0f;
  for (int i = 0; i < counts.x; ++i) {
    Slice slice = sliceAlong(shaded.normal, marchDirection(shaded.turn, i, counts.x, 0.5f * kTurn));
    uint closed = closedSectors(shaded, slice, -1.0f, counts.y) | closedSectors(shaded, slice, 1.0f, counts.y);
    float light = slice.weight * openSliceLight(slice.normal);
    open += light * (1.0f - float(bitCount(closed)) / kSectors);
    whole += light;
  }
  return clamp(open / (normalisedBySamples() ? whole : float(counts.x)), 0.0f, 1.0f);
}
