// How far a ray may go from one cell: to the far face of the cell, or through the ball known to be free of surface.

// Parameter at which the ray leaves the cell, and the axis of that face. The same expression gives the entry into the
// next cell, so the intervals of consecutive cells abut exactly.
struct CellExit {
  float t;
  int axis;
};

CellExit cellExit(vec3 origin, vec3 inverseDirection, ivec3 cell) {
  vec3 face = vec3(cell) + vec3(inverseDirection.x > 0.0f ? 1.0f : 0.0f, inverseDirection.y > 0.0f ? 1.0f : 0.0f,
                                inverseDirection.z > 0.0f ? 1.0f : 0.0f);
  vec3 t = (face - origin) * inverseDirection;
  float leave = min(t.x, min(t.y, t.z));
  return CellExit(leave, t.x == leave ? 0 : (t.y == leave ? 1 : 2));
}

// How much further the ray may go from `point`, which lies in the cell, before it leaves the ball of that radius about
// the centre of the cell; <= 0 if the point is outside the ball. `direction` as in Ray, `spacing` in smallest spacings.
float ballExit(vec3 point, vec3 direction, ivec3 cell, vec3 spacing, float radius) {
  vec3 offset = (point - (vec3(cell) + 0.5f)) * spacing;
  float along = dot(offset, direction * spacing);
  float inside = along * along - dot(offset, offset) + radius * radius;
  return inside > 0.0f ? sqrt(inside) - along : 0.0f;
}
