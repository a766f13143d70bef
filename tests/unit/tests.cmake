isolume_test(test_sweep
  unit/octants_test.cpp
  unit/level_test.cpp
  unit/geometry_terms_test.cpp
  unit/start_test.cpp
  unit/distance_test.cpp
  unit/fixed_point_test.cpp
  unit/band_test.cpp
  unit/rotated_shadow_test.cpp
  unit/visibility_test.cpp
  unit/combined_visibility_test.cpp
  unit/fixed_light_test.cpp
  unit/layout_test.cpp
  unit/large_index_test.cpp
  support/plain_light.cpp
  support/plain_start.cpp
  support/plain_sweep.cpp
  support/random_grids.cpp
  LIBS isolume_sweep hwy::hwy)
isolume_test(test_closest
  unit/closest_test.cpp
  unit/closest_pass_test.cpp
  unit/closest_degenerate_test.cpp
  unit/closest_extent_test.cpp
  unit/closest_points_test.cpp
  unit/closest_property_test.cpp
  support/plain_closest.cpp
  LIBS isolume_sweep hwy::hwy)
