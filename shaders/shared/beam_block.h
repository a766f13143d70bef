// Blocks of pixels that are traced together first, in C++ and in GLSL alike (shaders/beam.frag explains them).
const int kBeamBlock = 8;          // pixels along each side
const float kBeamMissed = 3e38f;   // parameter of a beam that meets nothing
