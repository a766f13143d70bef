// What the screen-space passes are told, std140; the same text is a C++ struct in namespace shader
// (raymarch/screen/screen_uniforms.h checks its layout). Lengths are in radii: one unit is the neighbourhood's radius.
// Camera axes: x to the right, y down, z along the view; depth z is 0 on the plane of FrameUniforms::planePoint.
const int kMostScreenSamples = 256;
const int kConeAngles = 8;        // of the convolved skies
const int kSkyCells = 96;         // of the sky that directions are drawn from, and
const int kCellDraws = 16;        // directions in each
const float kNothingSeen = 1e9f;  // depth of a pixel that shows no surface

struct ScreenUniforms {
  vec4 picture;     // xy: centre of the picture, pixels; z: side of a pixel on the plane; w: 1 / the plane's depth, or 0
  vec4 toX;         // grid axes to camera axes, orthonormal rows; w of toX: thickness of what is seen
  vec4 toY;         // w: scale of the second radius, or 0
  vec4 toZ;         // w: voxels along the view that a radius has
  vec4 depthRow;    // xyz: index step to depth; w: depth of the pixels that show nothing, for means
  vec4 indexX;      // camera axes to index steps, columns
  vec4 indexY;
  vec4 indexZ;
  ivec4 size;       // xy: pixels of the picture; z: samples; w: side of the interleaving pattern
  ivec4 modes;      // x: characteristic function; y: 1 normalised by the samples; z: 1 clamped to the tangent plane;
                    // w: 1 with light from the neighbourhood
  ivec4 march;      // x: directions; y: steps along each; z: further points on the way to a sample; w: BentLight,
                    // and 4 with the geometric term
};

struct ScreenSamples {
  vec4 samples[kMostScreenSamples];
};
