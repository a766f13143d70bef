// The first crossing along a ray.
//
// The ray leaps through cubes of cells that the clearance texture certifies to be free of surface, and in each cell that
// the surface may pass it asks the exact cubic. No iteration limit is needed: every turn leaves at least one cell behind,
// and a ray crosses fewer than size.x + size.y + size.z cells.
//
// Three loops, each with one kind of work, because the lanes of a SIMD machine do everything that a loop holds whenever
// one of them needs it: leaps; cells that may hold a crossing; crossings. None runs in vain: each decides at its end.
//
// The ray starts where the beam of its block stopped (beam.frag): so far there is neither surface nor solid.
//
// A ray that begins at the eye inside the solid looks for the way out: it sees the surface, or the cap, from within.

// In smallest spacings: far more than rounding can move where a beam stopped, far less than a leap.
const float kBeamMargin = 0.01f;

Hit trace(Ray ray) {
  Hit miss = Hit(false, vec3(0.0f), -1);
  vec3 high = vec3(frame.gridSize.xyz - 1);
  vec3 direction = ray.direction;
  vec3 inverse = 1.0f / direction;
  BoxSpan span = boxSpan(ray.origin, inverse, high);
  float beam = texelFetch(beamTexture, ivec2(gl_FragCoord.xy) / kBeamBlock, 0).r;
  float clear = max(ray.start, beam * ray.perBeam - kBeamMargin);
  float begin = max(span.enter, clear);
  if (!(span.leave > begin)) return miss;

  // From here on the ray starts where it enters the box (t = 0), which keeps float positions exact to about 1e-7 size.
  vec3 origin = clamp(ray.origin + begin * direction, vec3(0.0f), high);
  bool fromFace = span.enter >= clear;
  if (fromFace) origin[span.enterAxis] = direction[span.enterAxis] > 0.0f ? 0.0f : high[span.enterAxis];
  vec3 lastCell = high - 1.0f;
  Walk walk = makeWalk(origin, direction, inverse, lastCell);
  ClearanceMap map = clearanceMap(walk);
  vec3 cell = clamp(floor(walk.origin), vec3(0.0f), lastCell);

  // Relative to the side of the ray, a code of 1 to kClearanceRadiusMask is free space, above it the other side.
  uint code = cellClearance(map, cell);
  uint sideBit = code & kClearanceInside;
  uint room = code ^ sideBit;
  // 1 outside, -1 inside; 0: not known before the first cell is solved.
  float side = room == 0u ? 0.0f : (sideBit == 0u ? 1.0f : -1.0f);
  bool leaping = room != 0u;
  float radius = float(room);
  bool capped = side < 0.0f && fromFace;
  bool inBox = !capped;

  float t = 0.0f;
  float len = 0.0f;
  Cubic cubic = Cubic(0.0f, 0.0f, 0.0f, 0.0f);
  Bracket bracket = Bracket(false, 0.0f, 0.0f);
  if (inBox) {
    do {
      bool candidate = false;
      do {
        if (leaping) {
          do {
            CubeExit leave = cubeExit(walk, cell, radius);
            t = larger(t, leave.t);
            cell = leave.next;
            inBox = cell.x <= lastCell.x && cell.y <= lastCell.y && cell.z <= lastCell.z;
            code = cellClearance(map, cell);
            room = code ^ sideBit;
            radius = float(room);
            leaping = inBox && room - 1u < kClearanceRadiusMask;
          } while (leaping);
        }
        if (inBox) {
          len = larger(cellExit(walk, cell) - t, 0.0f);
          cubic = levelAlongRay(gridCell(walk, cell), origin, direction, t);
          if (side == 0.0f) {
            side = cubic.a > 0.0f ? -1.0f : 1.0f;
            sideBit = cubic.a > 0.0f ? kClearanceInside : 0u;
            capped = cubic.a > 0.0f && fromFace;
          }
          cubic = Cubic(side * cubic.a, side * cubic.b, side * cubic.c, side * cubic.d);
          // A free cell of the other side: rounding hid the root between it and the cell before.
          candidate = capped || code != 0u || mayRise(cubic, len);
          leaping = true;
          radius = 1.0f;
        }
      } while (inBox && !candidate);
      if (inBox) {
        bracket = firstRise(cubic, len);
        if (code != 0u) bracket = Bracket(true, 0.0f, 0.0f);
      }
    } while (inBox && !capped && !bracket.found);
  }

  if (capped) return Hit(true, origin, span.enterAxis);
  if (bracket.found) {
    t += refineRise(cubic, bracket);
    return Hit(true, clamp(origin + t * direction, vec3(0.0f), high), -1);
  }
  if (side >= 0.0f) return miss;
  vec3 exit = clamp(origin + (span.leave - begin) * direction, vec3(0.0f), high);
  exit[span.leaveAxis] = direction[span.leaveAxis] > 0.0f ? high[span.leaveAxis] : 0.0f;
  return Hit(true, exit, span.leaveAxis);
}
