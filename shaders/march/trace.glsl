// The first crossing along a ray.
//
// The ray leaps through cubes of cells that the clearance texture certifies to be free of surface, one cell at the least,
// and in each cell that the surface may pass it solves the exact cubic. No iteration limit is needed: every turn leaves
// at least one cell behind, and a ray crosses fewer than size.x + size.y + size.z cells.
//
// The ray starts where the beam of its block stopped (beam.frag): so far there is neither surface nor solid.
//
// A ray that begins at the eye inside the solid looks for the way out: it sees the surface, or the cap, from within.

// In smallest spacings: far more than rounding can move where a beam stopped, far less than a leap.
const float kBeamMargin = 0.01f;

bool isWithin(ivec3 cell, ivec3 lastCell) { return cell == clamp(cell, ivec3(0), lastCell); }

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
  float end = span.leave - begin;
  ivec3 lastCell = frame.gridSize.xyz - 2;
  ivec3 cell = clamp(ivec3(origin), ivec3(0), lastCell);

  uint clearance = cellClearance(cell);
  bool startsInside =
      mayHoldSurface(clearance) ? levelAlongRay(cell, origin, direction, 0.0f, 1.0f).a > 0.0f : isInside(clearance);
  if (startsInside && fromFace) return Hit(true, origin, span.enterAxis);
  float side = startsInside ? -1.0f : 1.0f;

  float t = 0.0f;
  Cubic cubic = Cubic(0.0f, 0.0f, 0.0f, 0.0f);
  Bracket bracket = Bracket(false, 0.0f, 0.0f);
  bool inBox = true;
  while (inBox) {
    while (inBox && !mayHoldSurface(clearance) && isInside(clearance) == startsInside) {
      CubeExit leave = cubeExit(origin, direction, inverse, cell, clearRadius(clearance));
      t = max(t, leave.t);
      cell = leave.next;
      inBox = isWithin(cell, lastCell);
      if (inBox) clearance = cellClearance(cell);
    }
    if (!inBox) break;

    if (!mayHoldSurface(clearance)) {  // beyond the surface: rounding hid the root between the two cells
      bracket = Bracket(true, 0.0f, 0.0f);
      break;
    }
    CubeExit leave = cubeExit(origin, direction, inverse, cell, 1);
    cubic = levelAlongRay(cell, origin, direction, t, side);
    bracket = firstRise(cubic, max(leave.t - t, 0.0f));
    if (bracket.found) break;
    t = max(t, leave.t);
    cell = leave.next;
    inBox = isWithin(cell, lastCell);
    if (inBox) clearance = cellClearance(cell);
  }

  if (bracket.found) {
    t += refineRise(cubic, bracket);
    return Hit(true, clamp(origin + t * direction, vec3(0.0f), high), -1);
  }
  if (!startsInside) return miss;
  vec3 exit = clamp(origin + end * direction, vec3(0.0f), high);
  exit[span.leaveAxis] = direction[span.leaveAxis] > 0.0f ? high[span.leaveAxis] : 0.0f;
  return Hit(true, exit, span.leaveAxis);
}
