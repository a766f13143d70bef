// The first crossing along a ray.
//
// The ray leaps through cubes of cells that the clearance texture certifies to be free of surface, and in each cell that
// the surface may pass it asks the exact cubic. No iteration limit is needed: every turn leaves at least one cell behind,
// and a ray crosses fewer than size.x + size.y + size.z cells.
//
// Three loops, each with one kind of work, because the lanes of a SIMD machine do everything that a loop holds whenever
// one of them needs it: leaps; cells that may hold a crossing; crossings. None runs in vain: each decides at its end.

struct Crossing {
  bool capped;      // the ray starts within the solid, at a face of the box
  float side;       // of where it starts: 1 outside, -1 inside
  float t;          // of where the bracket's cell is entered
  Cubic cubic;      // side times the level from there on
  Bracket bracket;  // of the crossing; not found: there is none
};

// From a point of the box on. `fromFace`: the ray enters the box there. `rounding` > 0: the ray leaves the surface, and
// the level is taken to be lower by that on its way (shadow.glsl); 0: the side is found out.
Crossing firstCrossing(vec3 origin, vec3 direction, vec3 inverse, bool fromFace, float rounding) {
  bool leaves = rounding > 0.0f;
  vec3 lastCell = vec3(frame.gridSize.xyz - 2);
  Walk walk = makeWalk(origin, direction, inverse, lastCell);
  ClearanceMap map = clearanceMap(walk);
  vec3 cell = clamp(floor(walk.origin), vec3(0.0f), lastCell);

  // Relative to the side of the ray, a code of 1 to kClearanceRadiusMask is free space, above it the other side.
  uint code = cellClearance(map, cell);
  uint sideBit = leaves ? 0u : code & kClearanceInside;
  uint room = code ^ sideBit;
  // 1 outside, -1 inside; 0: not known before the first cell is solved.
  float side = leaves ? 1.0f : room == 0u ? 0.0f : (sideBit == 0u ? 1.0f : -1.0f);
  bool leaping = room - 1u < kClearanceRadiusMask;
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
          cubic = Cubic(side * cubic.a - rounding, side * cubic.b, side * cubic.c, side * cubic.d);
          // A free cell of the other side: rounding hid the root between it and the cell before.
          candidate = capped || (code != 0u && !leaves) || mayRise(cubic, len);
          leaping = true;
          radius = 1.0f;
        }
      } while (inBox && !candidate);
      if (inBox) {
        bracket = firstRise(cubic, len);
        if (code != 0u && !leaves) bracket = Bracket(true, 0.0f, 0.0f);
      }
    } while (inBox && !capped && !bracket.found);
  }
  return Crossing(capped, side, t, cubic, bracket);
}

// In smallest spacings: far more than rounding can move where a beam stopped, far less than a leap.
const float kBeamMargin = 0.01f;

// What the eye sees. The ray starts where the beam of its block stopped (beam.frag): so far there is neither surface nor
// solid. A ray that begins at the eye inside the solid looks for the way out: it sees the surface, or the cap, from
// within.
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
  Crossing crossing = firstCrossing(origin, direction, inverse, fromFace, 0.0f);

  if (crossing.capped) return Hit(true, origin, span.enterAxis);
  if (crossing.bracket.found) {
    float t = crossing.t + refineRise(crossing.cubic, crossing.bracket);
    return Hit(true, clamp(origin + t * direction, vec3(0.0f), high), -1);
  }
  if (crossing.side >= 0.0f) return miss;
  vec3 exit = clamp(origin + (span.leave - begin) * direction, vec3(0.0f), high);
  exit[span.leaveAxis] = direction[span.leaveAxis] > 0.0f ? high[span.leaveAxis] : 0.0f;
  return Hit(true, exit, span.leaveAxis);
}
