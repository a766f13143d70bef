// How the byte of a cell in the clearance texture is read, in C++ and in GLSL alike (raymarch/clearance.h explains it).
// Bits 0 to 6: 0 = the surface may pass through the cell; n > 0: neither through it nor through any cell less than n
// away along each axis. Bit 7 (0 in mixed cells): all corners inside.
const uint kClearanceInside = 0x80u;
const uint kClearanceRadiusMask = 0x7fu;
