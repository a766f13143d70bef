# An independent tracer on a mesh of the same volume, where Embree is found; the cases that use it exist only then.
find_package(embree 3 QUIET)
if(embree_FOUND)
  add_library(isolume_test_embree STATIC support/embree_scene.cpp support/tetra_mesh.cpp)
  target_include_directories(isolume_test_embree PUBLIC ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/tests)
  target_link_libraries(isolume_test_embree PUBLIC isolume_flags isolume_reference PRIVATE embree)
else()
  message(STATUS "Embree 3 not found: no test against an independent tracer")
endif()

set(ISOLUME_REFERENCE_TESTS
  reference/analytic_hits_test.cpp
  reference/brute_force.cpp
  reference/brute_force_test.cpp
  reference/cubic_test.cpp
  reference/hit_judge.cpp
  reference/length_inside_test.cpp)
if(TARGET isolume_test_embree)
  list(APPEND ISOLUME_REFERENCE_TESTS reference/embree_test.cpp)
endif()
isolume_test(test_reference ${ISOLUME_REFERENCE_TESTS} support/cpu_tracer.cpp
  LIBS isolume_reference isolume_volumes isolume_raymarch isolume_readers $<TARGET_NAME_IF_EXISTS:isolume_test_embree>)
