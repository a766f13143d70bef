// The first crossing along a ray.
//
// Far from the surface the ray leaps through balls that the clearance texture certifies; next to it, it walks cell by
// cell (integers, so that no cell is skipped), and in each cell that the surface may pass it solves the exact cubic. No
// iteration limit is needed but that of the walk: every turn leaves at least one cell behind, and a ray crosses fewer
// than size.x + size.y + size.z cells.
//
// A ray that begins at the eye inside the solid looks for the way out: it sees the surface, or the cap, from within.

// A leap must go at least that far beyond the cell, so that rounding cannot bring it back: progress.
const float kLeastLeap = 0.01f;

Hit trace(Ray ray) {
  Hit miss = Hit(false, vec3(0.0f), -1);
  vec3 high = vec3(frame.gridSize.xyz - 1);
  vec3 direction = ray.direction;
  vec3 inverse = 1.0f / direction;
  BoxSpan span = boxSpan(ray.origin, inverse, high);
  float begin = max(span.enter, ray.start);
  if (!(span.leave > begin)) return miss;

  // From here on the ray starts where it enters the box (t = 0), which keeps float positions exact to about 1e-7 size.
  vec3 origin = clamp(ray.origin + begin * direction, vec3(0.0f), high);
  bool fromFace = span.enter >= ray.start;
  if (fromFace) origin[span.enterAxis] = direction[span.enterAxis] > 0.0f ? 0.0f : high[span.enterAxis];
  float end = span.leave - begin;
  ivec3 lastCell = frame.gridSize.xyz - 2;
  ivec3 forward = ivec3(sign(direction));
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
    // Leap or walk until a cell needs a look.
    while (inBox && !mayHoldSurface(clearance) && isInside(clearance) == startsInside) {
      CellExit leave = cellExit(origin, inverse, cell);
      float leap = t + ballExit(origin + t * direction, direction, cell, frame.scale.xyz, clearRadius(clearance));
      if (leap > leave.t + kLeastLeap) {
        t = leap;
        cell = clamp(ivec3(origin + t * direction), ivec3(0), lastCell);
        inBox = t < end;
      } else {
        t = max(t, leave.t);
        cell[leave.axis] += forward[leave.axis];
        inBox = cell[leave.axis] >= 0 && cell[leave.axis] <= lastCell[leave.axis];
      }
      if (inBox) clearance = cellClearance(cell);
    }
    if (!inBox) break;

    if (!mayHoldSurface(clearance)) {  // beyond the surface: rounding hid the root between the two cells
      bracket = Bracket(true, 0.0f, 0.0f);
      break;
    }
    CellExit leave = cellExit(origin, inverse, cell);
    cubic = levelAlongRay(cell, origin, direction, t, side);
    bracket = firstRise(cubic, max(leave.t - t, 0.0f));
    if (bracket.found) break;
    t = max(t, leave.t);
    cell[leave.axis] += forward[leave.axis];
    inBox = cell[leave.axis] >= 0 && cell[leave.axis] <= lastCell[leave.axis];
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
