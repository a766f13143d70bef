// How a surface is coloured by another field, std140; the same text is a C++ struct in namespace shader
// (raymarch/surface_colors.cpp checks its layout).
struct ColorUniforms {
  vec4 toX;      // index space of the picture's grid to that of the field, rows
  vec4 toY;
  vec4 toZ;
  vec4 unknown;  // linear: where there is no value
  ivec4 size;    // xyz: samples of the field; w: colours of the map
};
