// The ray through a point of the picture, in index space.
//
// Origins lie on a plane near the grid, not at the eye: with the eye a million voxels away, eye + t * direction would
// lose the voxel in float, while a point of the plane and its difference to the eye keep full relative precision.

struct Ray {
  vec3 origin;
  vec3 direction;  // one unit of the parameter is one smallest spacing of physical length
  float start;     // parameter of the eye (perspective) or of the plane through it (orthographic)
  float perBeam;   // change of the parameter per unit of a beam's s (lib/beam.glsl)
};

// Components of the direction are kept away from 0, so that 1 / direction stays finite. 1e-9 of a voxel per voxel is
// far below what float resolves over any grid.
const float kSmallestStep = 1e-9f;

float awayFromZero(float x) {
  return abs(x) < kSmallestStep ? (x < 0.0f ? -kSmallestStep : kSmallestStep) : x;
}

// `pixel` is relative to the centre of the picture, y down.
Ray cameraRay(vec4 planePoint, vec4 planeX, vec4 planeY, vec4 eye, vec4 scale, vec2 pixel) {
  vec3 spacing = vec3(scale.x, scale.y, scale.z);
  vec3 centre = vec3(planePoint.x, planePoint.y, planePoint.z);
  vec3 right = vec3(planeX.x, planeX.y, planeX.z);
  vec3 down = vec3(planeY.x, planeY.y, planeY.z);
  vec3 origin = centre + (right * pixel.x + down * pixel.y);
  vec3 along = eye.w * origin - vec3(eye.x, eye.y, eye.z);
  float len = length(along * spacing);
  vec3 direction = along / len;
  return Ray(origin, vec3(awayFromZero(direction.x), awayFromZero(direction.y), awayFromZero(direction.z)),
             eye.w > 0.0f ? -len : -planePoint.w, len);
}
