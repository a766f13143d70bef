// Two colour maps that can be read without colour, straight lines in CIELAB (D65 white) between control points, within
// sRGB. [CIE15] for CIELAB. Thread-safe.
//
// Diverging: blue below 0, near white at 0, orange to brown above.
//
// Lightness falls evenly from 96 at 0 to 38 at either end and is the same for t and -t: the size of a difference can be
// read even without colour, and blue against orange stays apart for red-green-blind eyes.
//
// Sequential: dark violet, blue, green, yellow, with lightness that rises evenly from 20 to 91.
#pragma once

#include <glm/vec3.hpp>

namespace isolume {

/// Linear sRGB in [0, 1] for t in [-1, 1]; beyond it the colour of the end. t must not be NaN.
glm::vec3 divergingColor(double t);

/// Linear sRGB in [0, 1] for t in [0, 1]; beyond it the colour of the end. t must not be NaN.
glm::vec3 sequentialColor(double t);

}  // namespace isolume
