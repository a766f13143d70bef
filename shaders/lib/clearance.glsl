// How a ray crosses the cells of a grid: in leaps through cubes of cells that are known to be free of surface.
//
// The ray is turned so that it rises along every axis: an axis along which it falls is counted from its far end. One
// formula then serves every direction, and what the ray leaves behind is what is smaller. Cells are whole numbers in
// floats, exact up to 2^24.

struct Walk {
  vec3 origin;     // of the turned ray, in the box [0, lastCell + 1]
  vec3 direction;  // > 0
  vec3 inverse;    // 1 / direction
  vec3 turn;       // 1, or -1 along the axes that are counted from the far end
  vec3 base;       // 0, or the last cell there
};

Walk makeWalk(vec3 origin, vec3 direction, vec3 inverseDirection, vec3 lastCell) {
  vec3 falls = vec3(direction.x > 0.0f ? 0.0f : 1.0f, direction.y > 0.0f ? 0.0f : 1.0f, direction.z > 0.0f ? 0.0f : 1.0f);
  vec3 turn = 1.0f - 2.0f * falls;
  vec3 base = falls * lastCell;
  return Walk(turn * origin + (base + falls), abs(direction), abs(inverseDirection), turn, base);
}

// The cell of the grid that a cell of the walk is.
vec3 gridCell(Walk walk, vec3 cell) { return walk.base + walk.turn * cell; }

// min and max without their care for NaN, which costs as much again as the comparison.
float smaller(float a, float b) { return a < b ? a : b; }
float larger(float a, float b) { return a > b ? a : b; }

// Parameters at which the ray passes the upper faces of the cube of `radius` >= 1 cells from `cell` on. The same
// expression from either side, so that the intervals of consecutive cells abut exactly.
vec3 faceTimes(Walk walk, vec3 cell, float radius) { return ((cell + radius) - walk.origin) * walk.inverse; }

// Parameter at which the ray leaves `cell`.
float cellExit(Walk walk, vec3 cell) {
  vec3 t = faceTimes(walk, cell, 1.0f);
  return smaller(t.x, smaller(t.y, t.z));
}

// Where the ray leaves the cube of cells less than `radius` away from `cell` along each axis (radius 1 is the cell
// itself), and the cell that it enters: the one behind the face, or the faces if it meets several at once. Along the
// other axes it is where the ray is, but never back, whatever rounding says: so each leap leaves a cell behind for good.
struct CubeExit {
  float t;
  vec3 next;
};

CubeExit cubeExit(Walk walk, vec3 cell, float radius) {
  vec3 t = faceTimes(walk, cell, radius);
  float leave = smaller(t.x, smaller(t.y, t.z));
  vec3 at = floor(walk.origin + leave * walk.direction);
  return CubeExit(leave, vec3(larger(at.x, t.x == leave ? cell.x + radius : cell.x),
                              larger(at.y, t.y == leave ? cell.y + radius : cell.y),
                              larger(at.z, t.z == leave ? cell.z + radius : cell.z)));
}
