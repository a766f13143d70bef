# Build rules shared by every target: language level, warnings, exact floating point.

set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

# Where the program finds its own shaders is decided at build time (they are embedded), so nothing else is global.
add_library(isolume_flags INTERFACE)
target_compile_features(isolume_flags INTERFACE cxx_std_20)
target_compile_options(isolume_flags INTERFACE
  -Wall -Wextra -Wshadow -Wconversion -Wno-sign-conversion
  # The same bits on every instruction set: no fused multiply-add unless it is written down.
  -ffp-contract=off
  # Neither flag changes a result: nobody reads the floating-point exception flags or errno.
  -fno-trapping-math -fno-math-errno)
