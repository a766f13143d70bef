# The programs that scripts/report runs: ours and the peers'. A peer whose library is missing leaves a gap in the
# report.
find_package(CLI11 REQUIRED)
set(CMAKE_MESSAGE_LOG_LEVEL WARNING)  # ITK looks for programs of GDCM, which nothing here needs, and reports each
find_package(ITK 5 QUIET COMPONENTS ITKDistanceMap)
unset(CMAKE_MESSAGE_LOG_LEVEL)
find_package(embree 3 QUIET)
message(STATUS "Peers: ITK ${ITK_FOUND}, Embree ${embree_FOUND}")

add_library(isolume_report STATIC bench/report/report_program.cpp)
target_link_libraries(isolume_report PUBLIC isolume_app CLI11::CLI11 fmt::fmt)

set(ISOLUME_ITK_DISTANCE bench/peers/itk_absent.cpp)
if(ITK_FOUND)
  set(ISOLUME_ITK_DISTANCE bench/peers/itk_distance.cpp)
endif()
add_executable(report_distance
  bench/report/closest_distance.cpp
  bench/report/distance_report.cpp
  bench/report/isolume_distance.cpp
  bench/report/shapes.cpp
  bench/report/voxel_sample.cpp
  bench/peers/openvdb_distance.cpp
  ${ISOLUME_ITK_DISTANCE})
target_link_libraries(report_distance PRIVATE OpenVDB::openvdb)
if(ITK_FOUND)
  target_include_directories(report_distance SYSTEM PRIVATE ${ITK_INCLUDE_DIRS})
  target_link_libraries(report_distance PRIVATE ${ITK_LIBRARIES})
endif()
add_executable(report_frames bench/report/frame_report.cpp)
add_executable(report_scene bench/report/scene_report.cpp)
add_executable(report_screen
  bench/report/light_rows.cpp bench/report/screen_report.cpp bench/report/screen_truth.cpp)
add_executable(report_calibration bench/report/calibration_report.cpp bench/report/surface_sample.cpp)
set(ISOLUME_REPORT_PROGRAMS report_calibration report_distance report_frames report_scene report_screen)
if(embree_FOUND)
  add_executable(peer_embree
    bench/peers/embree_occlusion.cpp bench/peers/embree_report.cpp bench/peers/surface_mesh.cpp)
  target_link_libraries(peer_embree PRIVATE OpenVDB::openvdb embree)
  list(APPEND ISOLUME_REPORT_PROGRAMS peer_embree)
endif()
include(bench/rays/rays.cmake)
foreach(program ${ISOLUME_REPORT_PROGRAMS})
  target_link_libraries(${program} PRIVATE isolume_report)
  set_target_properties(${program} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/report)
endforeach()
# scripts/report builds one target, whichever peers there are.
add_custom_target(report_programs DEPENDS ${ISOLUME_REPORT_PROGRAMS})
