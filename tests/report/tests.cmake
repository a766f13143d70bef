# The truth and the statistics behind scripts/report.
isolume_test(test_report
  report/closest_distance_test.cpp
  report/voxel_sample_test.cpp
  bench/report/closest_distance.cpp
  bench/report/voxel_sample.cpp
  LIBS isolume_sweep)

# Debian's Python, which holds Debian's modules, as scripts/report takes it.
find_program(ISOLUME_SYSTEM_PYTHON python3 PATHS /usr/bin NO_DEFAULT_PATH)
if(ISOLUME_SYSTEM_PYTHON)
  foreach(case calibration stats section styles table2 occlusion_rows process screen)
    add_test(NAME report.python.${case}
      # Discovery, which skips a module that asks for it; by name it would fail.
      COMMAND ${ISOLUME_SYSTEM_PYTHON} -m unittest discover --verbose --pattern ${case}_test.py
      WORKING_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR}/report)
    set_tests_properties(report.python.${case} PROPERTIES TIMEOUT 60 SKIP_REGULAR_EXPRESSION "skipped=[1-9]"
      ENVIRONMENT "PYTHONPATH=${PROJECT_SOURCE_DIR}/scripts/lib;PYTHONDONTWRITEBYTECODE=1")
  endforeach()
endif()
