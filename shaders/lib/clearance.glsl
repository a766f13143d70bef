// How far a ray may go from one cell: to the far face of the cube of cells that is known to be free of surface.

// Parameter at which the ray leaves the cube of cells less than `radius` >= 1 away from `cell` along each axis, and the
// cell that it enters there. Radius 1 is the cell itself. The same expression gives the face from either side, so the
// intervals of consecutive cells abut exactly, and the next cell is found by integers along the axis of the face.
struct CubeExit {
  float t;
  ivec3 next;
};

CubeExit cubeExit(vec3 origin, vec3 direction, vec3 inverseDirection, ivec3 cell, int radius) {
  bool forwardX = direction.x > 0.0f;
  bool forwardY = direction.y > 0.0f;
  bool forwardZ = direction.z > 0.0f;
  ivec3 low = cell - (radius - 1);
  ivec3 high = cell + (radius - 1);
  vec3 face = vec3(float(forwardX ? high.x + 1 : low.x), float(forwardY ? high.y + 1 : low.y),
                   float(forwardZ ? high.z + 1 : low.z));
  vec3 t = (face - origin) * inverseDirection;
  float leave = min(t.x, min(t.y, t.z));
  vec3 at = origin + leave * direction;
  // Along the other axes the ray is still within the cube, whatever rounding says.
  ivec3 next = clamp(ivec3(floor(at)), low, high);
  if (t.x == leave) {
    next.x = forwardX ? high.x + 1 : low.x - 1;
  } else if (t.y == leave) {
    next.y = forwardY ? high.y + 1 : low.y - 1;
  } else {
    next.z = forwardZ ? high.z + 1 : low.z - 1;
  }
  return CubeExit(leave, next);
}
