// 1 if p and the further points evenly on the way to it lie outside, else 0.
float openTo(vec3 p) {
  int parts = marchSteps() + 1;
  float open = 1.0f;
  for (int k = parts; k > 0 && open > 0.0f; --k) open = outside(p * (float(k) / float(parts)));
  return open;
}
