# Programs that judge rays, and count their steps.
add_executable(report_rays
  bench/rays/judged_volume.cpp
  bench/rays/picture_judge.cpp
  bench/rays/random_views.cpp
  bench/rays/ray_judge.cpp
  bench/rays/rays_report.cpp
  bench/report/shapes.cpp
  reference/brute_force.cpp)
list(APPEND ISOLUME_REPORT_PROGRAMS report_rays)
foreach(program report_rays)
  target_include_directories(${program} PRIVATE ${PROJECT_SOURCE_DIR}/tests)
endforeach()
