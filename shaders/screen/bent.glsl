// Bent normals ([Klehm11] Sec. 3.1): beside the share of directions that are open, their mean
//   N_b = (sum of d)^-1 * sum of d w,  d = 1 where the direction w is open,
// which in the open is N / 2. What passes from the estimator through the filter to the lookup is (share (N_b - N / 2),
// share): the difference to the open one, which leaves the normals as sharp as they are (Sec. 4), weighed by what it
// stands for, so that a pattern of pixels pools its samples.
struct Bent {
  vec3 bend;    // share (N_b - N / 2), in the frame of the shaded point
  float share;  // of the directions about the normal that are open
};

// With the axes of the normals in the G-buffer.
vec4 storedBend(Bent bent) { return vec4(gridDirection(bent.bend), bent.share); }
