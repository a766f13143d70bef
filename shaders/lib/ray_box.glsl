// Where a ray meets an axis-aligned box [0, high]: slab test. enter > leave: it does not.

struct BoxSpan {
  float enter;
  float leave;
  int enterAxis;
  int leaveAxis;
};

BoxSpan boxSpan(vec3 origin, vec3 inverseDirection, vec3 high) {
  vec3 t0 = -origin * inverseDirection;
  vec3 t1 = (high - origin) * inverseDirection;
  vec3 tNear = min(t0, t1);
  vec3 tFar = max(t0, t1);
  float enter = max(tNear.x, max(tNear.y, tNear.z));
  float leave = min(tFar.x, min(tFar.y, tFar.z));
  int enterAxis = tNear.x == enter ? 0 : (tNear.y == enter ? 1 : 2);
  int leaveAxis = tFar.x == leave ? 0 : (tFar.y == leave ? 1 : 2);
  return BoxSpan(enter, leave, enterAxis, leaveAxis);
}
