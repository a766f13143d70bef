// A diverging colour map: blue below 0, near white at 0, orange to brown above.
//
// Straight lines in CIELAB (D65 white) between five control points, so that lightness falls evenly from 96 at 0 to 38
// at either end and is the same for t and -t: the size of a difference can be read even without colour, and blue
// against orange stays apart for red-green-blind eyes. Both sides lie within sRGB. [CIE15] for CIELAB. Thread-safe.
#pragma once

#include <glm/vec3.hpp>

namespace isolume {

/// Linear sRGB in [0, 1] for t in [-1, 1]; beyond it the colour of the end. t must not be NaN.
glm::vec3 divergingColor(double t);

}  // namespace isolume
