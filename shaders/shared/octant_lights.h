// The light of the octants (sweep/octants.h), std140; the same text is a C++ struct in namespace shader
// (raymarch/octant_lights.h checks its layout).
struct OctantLights {
  vec4 low[3];   // red, green and blue, linear, of octants 0 to 3
  vec4 high[3];  // and of octants 4 to 7
  vec4 most;     // rgb: what an open point gets if every octant is as bright as the brightest
};
