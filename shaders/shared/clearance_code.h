// How the byte of a cell in the clearance texture is read, in C++ and in GLSL alike (raymarch/clearance.h explains it).
// Bits 0 to 6: 0 = the surface may pass through the cell; n > 0: it does not, and a ball of radius
// (n - 1) * kClearanceUnit about the centre of the cell, in smallest spacings, is free of it. Bit 7: all corners inside.
const uint kClearanceInside = 0x80u;
const uint kClearanceRadiusMask = 0x7fu;
const float kClearanceUnit = 0.5f;
