isolume_test(test_sweep
  unit/octants_test.cpp
  unit/level_test.cpp
  unit/geometry_terms_test.cpp
  unit/distance_test.cpp
  unit/visibility_test.cpp
  unit/layout_test.cpp
  support/plain_sweep.cpp
  LIBS isolume_sweep hwy::hwy)
isolume_test(test_closest
  unit/closest_test.cpp
  unit/closest_pass_test.cpp
  unit/closest_degenerate_test.cpp
  support/plain_closest.cpp
  LIBS isolume_sweep hwy::hwy)
if(ISOLUME_BUILD_BENCHMARKS)
  find_package(benchmark REQUIRED)
  add_executable(bench_closest bench/closest_bench.cpp)
  target_include_directories(bench_closest PRIVATE ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(bench_closest PRIVATE isolume_flags isolume_sweep benchmark::benchmark)
endif()
