# Estimates of the reference against closed forms and, where Embree is found, against an independent tracer.
set(ISOLUME_ESTIMATOR_TESTS
  estimators/bent_test.cpp
  estimators/environment_test.cpp
  estimators/light_test.cpp
  estimators/membership_test.cpp
  estimators/openness_test.cpp
  estimators/pixels_test.cpp
  estimators/sampling_test.cpp
  estimators/translucent_test.cpp)
set(ISOLUME_ESTIMATOR_LIBRARIES isolume_reference isolume_volumes)
if(TARGET isolume_test_embree)
  list(APPEND ISOLUME_ESTIMATOR_TESTS estimators/embree_test.cpp support/cpu_tracer.cpp)
  list(APPEND ISOLUME_ESTIMATOR_LIBRARIES isolume_test_embree isolume_raymarch isolume_readers)
endif()
isolume_test(test_estimators ${ISOLUME_ESTIMATOR_TESTS} LIBS ${ISOLUME_ESTIMATOR_LIBRARIES})
