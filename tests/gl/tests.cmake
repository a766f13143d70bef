set(gl "${CMAKE_CURRENT_LIST_DIR}")
isolume_test(test_gl
  ${gl}/beam_test.cpp
  ${gl}/camera_test.cpp
  ${gl}/clearance_test.cpp
  ${gl}/context_test.cpp
  ${gl}/coverage_test.cpp
  ${gl}/determinism_test.cpp
  ${gl}/edge_case_test.cpp
  ${gl}/gl_scene.cpp
  ${gl}/lights_test.cpp
  ${gl}/sampling_test.cpp
  ${gl}/shader_source_test.cpp
  ${gl}/octant_light_test.cpp
  ${gl}/shading_test.cpp
  ${gl}/shadow_test.cpp
  ${gl}/surface_color_test.cpp
  ${gl}/textures_test.cpp
  ${gl}/../support/cpu_tracer.cpp
  LIBS isolume_raymarch isolume_sweep isolume_reference isolume_readers isolume_volumes isolume_shaders isolume_glad
  fmt::fmt)
isolume_test(test_shader_math
  ${gl}/shader_math_test.cpp
  LIBS isolume_sweep)
