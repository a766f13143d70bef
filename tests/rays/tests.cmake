# Bounds to trace by, and the programs that judge rays (tests/bench/rays).
isolume_test(test_lower_bound
  rays/lower_bound_test.cpp
  bench/report/closest_distance.cpp
  LIBS isolume_sweep isolume_volumes)
