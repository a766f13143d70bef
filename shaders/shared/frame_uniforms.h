// Everything that the march shader is told about a picture, std140; the same text is a C++ struct in namespace shader
// (raymarch/frame_uniforms.h checks its layout). "Steps" below are index-space vectors; lengths along a ray are in units
// of the smallest spacing.
struct FrameUniforms {
  vec4 planePoint;  // point at the centre of the picture on a plane that faces the camera near the grid; w: its depth
  vec4 planeX;      // step on that plane from a pixel to its right neighbour
  vec4 planeY;      // step on that plane from a pixel to the one below
  vec4 eye;         // perspective: eye, 1. Orthographic: -direction, 0. So direction ~ w * planePoint - xyz
  vec4 scale;       // spacing / smallest spacing; w: how far above a hit the octants are read, voxels
  vec4 albedo;      // linear; w: 1 / gamma
  vec4 background;  // linear, premultiplied
  ivec4 gridSize;   // samples along each axis
  ivec4 modes;      // x: 0 normals from the data, 1 from the distance
};
