# The program from outside: every case starts the real binary and looks at its exit code, its two streams and its files.
isolume_test(test_cli
  cli/bad_input_test.cpp
  cli/color_test.cpp
  cli/command_line_test.cpp
  cli/compare_test.cpp
  cli/environment_test.cpp
  cli/fields_test.cpp
  cli/info_test.cpp
  cli/light_options_test.cpp
  cli/lights_test.cpp
  cli/occlusion_method_test.cpp
  cli/picture.cpp
  cli/program.cpp
  cli/provenance_test.cpp
  cli/real_volumes_test.cpp
  cli/reference_test.cpp
  cli/render_test.cpp
  cli/sample_test.cpp
  cli/screen_options_test.cpp
  cli/suggest_test.cpp
  cli/terminal_test.cpp
  cli/transport_options_test.cpp
  LIBS isolume_app fmt::fmt)
target_compile_definitions(test_cli PRIVATE ISOLUME_PROGRAM="$<TARGET_FILE:isolume>")
add_dependencies(test_cli isolume)
