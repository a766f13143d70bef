set(ISOLUME_IO_TESTS
  io/bad_input_test.cpp
  io/fields_test.cpp
  io/header_test.cpp
  io/metaimage_test.cpp
  io/nrrd_test.cpp
  io/raw_test.cpp
  io/samples_test.cpp
  io/shared_data_test.cpp
  io/statistics_test.cpp
  io/vdb_test.cpp)
if(TARGET ITKIOImageBase)
  list(APPEND ISOLUME_IO_TESTS io/itk_test.cpp)
endif()
isolume_test(test_io ${ISOLUME_IO_TESTS} LIBS isolume_readers OpenVDB::openvdb ZLIB::ZLIB fmt::fmt)
