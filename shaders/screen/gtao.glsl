// Ground-truth ambient occlusion ([Jimenez16]): in each plane through the line of sight the horizons h1 <= 0 <= h2 on
// both sides bound what is open, and the light between them, with the cosine of the normal, has a closed form. Points
// from the radius on do not count. O is the mean over the slices of weight * (light(h1) + light(h2)); normalised by the
// samples, it is divided by that of the same slices in the open.

// The horizon of one side (+1 or -1) of a slice, as a signed angle from the direction to the eye.
float gtaoHorizon(Shaded shaded, Slice slice, float side, int steps) {
  float horizon = slice.normal + side * kQuarterTurn;
  for (int j = 0; j < steps; ++j) {
    vec3 seen = sliceStep(shaded, slice, side, j, steps);
    if (occludes(seen)) horizon = side * min(side * horizon, angleFromEye(seen));
  }
  return horizon;
}

float gtaoOpenness(Shaded shaded) {
  ivec2 counts = marchCounts();
  float open = 0.0f;
  float whole = 0.0f;
  for (int i = 0; i < counts.x; ++i) {
    Slice slice = sliceAlong(shaded.normal, marchDirection(shaded.turn, i, counts.x, 0.5f * kTurn));
    float light = sliceLight(slice.normal, gtaoHorizon(shaded, slice, -1.0f, counts.y)) +
                  sliceLight(slice.normal, gtaoHorizon(shaded, slice, 1.0f, counts.y));
    open += slice.weight * light;
    whole += slice.weight * openSliceLight(slice.normal);
  }
  return clamp(open / (normalisedBySamples() ? whole : float(counts.x)), 0.0f, 1.0f);
}
