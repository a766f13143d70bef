# Bounds to trace by, and what judges rays and counts their steps (tests/bench/rays).
isolume_test(test_lower_bound
  rays/lower_bound_test.cpp
  bench/report/closest_distance.cpp
  LIBS isolume_sweep isolume_volumes)
isolume_test(test_rays
  rays/picture_judge_test.cpp
  rays/ray_judge_test.cpp
  rays/tracers_test.cpp
  bench/rays/octant_cubes.cpp
  bench/rays/picture_judge.cpp
  bench/rays/random_views.cpp
  bench/rays/ray_judge.cpp
  bench/rays/ray_position.cpp
  bench/rays/shader_march.cpp
  bench/rays/sphere_tracers.cpp
  reference/brute_force.cpp
  LIBS isolume_app fmt::fmt)
