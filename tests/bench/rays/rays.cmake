# Programs that judge rays, and count their steps.
add_library(isolume_rays STATIC
  bench/rays/judged_volume.cpp
  bench/rays/picture_judge.cpp
  bench/rays/random_views.cpp
  bench/rays/ray_judge.cpp
  bench/report/shapes.cpp
  reference/brute_force.cpp)
target_include_directories(isolume_rays PUBLIC ${PROJECT_SOURCE_DIR}/tests)
target_link_libraries(isolume_rays PUBLIC isolume_report)
add_executable(report_rays bench/rays/rays_report.cpp)
add_executable(report_steps
  bench/rays/octant_cubes.cpp
  bench/rays/ray_position.cpp
  bench/rays/shader_march.cpp
  bench/rays/sphere_tracers.cpp
  bench/rays/steps_report.cpp)
foreach(program report_rays report_steps)
  target_link_libraries(${program} PRIVATE isolume_rays)
  list(APPEND ISOLUME_REPORT_PROGRAMS ${program})
endforeach()
