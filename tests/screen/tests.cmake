set(screen "${CMAKE_CURRENT_LIST_DIR}")
isolume_test(test_screen
  ${screen}/bent_picture_test.cpp
  ${screen}/bent_test.cpp
  ${screen}/closed_form_test.cpp
  ${screen}/estimate.cpp
  ${screen}/orderings_test.cpp
  ${screen}/picture_light_test.cpp
  ${screen}/picture_settings_test.cpp
  ${screen}/picture_test.cpp
  ${screen}/point_sets_test.cpp
  ${screen}/sky_light_test.cpp
  ${screen}/sky_test.cpp
  ${screen}/../gl/gl_scene.cpp
  LIBS isolume_raymarch isolume_sweep isolume_volumes)
