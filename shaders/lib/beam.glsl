// A beam: the box around all rays of a block of pixels, at each depth.
//
// With s the depth in units of the picture plane's distance from the eye (s = -1 at the eye, 0 on the plane; in an
// orthographic picture s is the length along the view), the ray of pixel p is at o(p) + s a(p), where o and a are linear
// in p. So along each axis the rays of a block lie between lower and upper bounds that are linear in s, and where the
// beam leaves a box is a division, not a search. The bounds hold while no ray is behind the eye (s >= -1).

struct Beam {
  vec3 lower;       // bounds at s = 0
  vec3 upper;
  vec3 lowerSlope;  // and their change with s
  vec3 upperSlope;
};

// Stands for "never" and for "no bound", and can still be multiplied by small numbers.
const float kBeamFar = 1e30f;

// `reach` is half the extent of the block on the picture plane along each axis, `margin` what rounding may move a point.
Beam makeBeam(vec3 centre, vec3 along, vec3 reach, float perspective, float margin) {
  return Beam(centre - reach - margin, centre + reach + margin, along - perspective * reach,
              along + perspective * reach);
}

// Where a bound that rises passes `limit`; never if it does not rise.
float risesAbove(float value, float slope, float limit) { return slope > 0.0f ? (limit - value) / slope : kBeamFar; }

// From where on some ray of the beam may be within the box [0, high], s >= `from`; kBeamFar or more: nowhere.
float beamEnters(Beam beam, vec3 high, float from) {
  float s = from;
  for (int axis = 0; axis < 3; ++axis) {
    if (beam.upper[axis] + s * beam.upperSlope[axis] < 0.0f) {
      s = max(s, risesAbove(beam.upper[axis], beam.upperSlope[axis], 0.0f));
    }
    if (beam.lower[axis] + s * beam.lowerSlope[axis] > high[axis]) {
      s = max(s, risesAbove(-beam.lower[axis], -beam.lowerSlope[axis], -high[axis]));
    }
  }
  return s;
}

// From where on no ray of the beam is within the box [0, high] any more.
float beamPasses(Beam beam, vec3 high) {
  float s = kBeamFar;
  for (int axis = 0; axis < 3; ++axis) {
    s = min(s, risesAbove(beam.lower[axis], beam.lowerSlope[axis], high[axis]));
    s = min(s, risesAbove(-beam.upper[axis], -beam.upperSlope[axis], 0.0f));
  }
  return s;
}

// Up to where every ray of the beam stays within [low, high] from `from` on; below `from` if one is outside there.
float beamStaysWithin(Beam beam, vec3 low, vec3 high, float from) {
  float s = kBeamFar;
  for (int axis = 0; axis < 3; ++axis) {
    s = min(s, risesAbove(beam.upper[axis], beam.upperSlope[axis], high[axis]));
    s = min(s, risesAbove(-beam.lower[axis], -beam.lowerSlope[axis], -low[axis]));
    if (beam.upper[axis] + from * beam.upperSlope[axis] > high[axis] ||
        beam.lower[axis] + from * beam.lowerSlope[axis] < low[axis]) {
      s = -kBeamFar;
    }
  }
  return s;
}
