// The calibration file as text, embedded when the program is built.
#pragma once

namespace isolume {

extern const char* const kCalibrationText;

}  // namespace isolume
