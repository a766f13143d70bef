# Imported targets must be visible wherever isolume_readers is linked, not just in this folder.
set(CMAKE_FIND_PACKAGE_TARGETS_GLOBAL TRUE)

# OpenVDB ships a find module, outside CMake's own search path.
list(APPEND CMAKE_MODULE_PATH "/usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/cmake/OpenVDB")
set(CMAKE_MESSAGE_LOG_LEVEL WARNING)  # it prints its components
find_package(OpenVDB REQUIRED COMPONENTS openvdb)
unset(CMAKE_MESSAGE_LOG_LEVEL)
find_package(ZLIB REQUIRED)

# ITK reads what the project's own readers do not: attached and compressed NRRD, NIfTI, MRC and others.
set(ISOLUME_ITK_SOURCE itk_absent.cpp)
if(ISOLUME_WITH_ITK)
  # Debian's ITK looks for the programs of GDCM too and reports each one that is not installed; nothing here needs them.
  set(CMAKE_MESSAGE_LOG_LEVEL WARNING)
  find_package(ITK 5 QUIET COMPONENTS
    ITKIOImageBase ITKIOGIPL ITKIOMeta ITKIOMRC ITKIONIFTI ITKIONRRD ITKIOTIFF ITKIOVTK)
  unset(CMAKE_MESSAGE_LOG_LEVEL)
  if(ITK_FOUND)
    set(ISOLUME_ITK_SOURCE itk_reader.cpp)
  endif()
  message(STATUS "Reading through ITK: ${ITK_FOUND}")
endif()

add_library(isolume_readers STATIC
  byte_hash.cpp
  byte_order_hint.cpp
  header_text.cpp
  inflate.cpp
  input_file.cpp
  memory_limit.cpp
  metaimage.cpp
  nrrd.cpp
  placement.cpp
  raw.cpp
  raw_samples.cpp
  samples.cpp
  statistics.cpp
  stored_size.cpp
  vdb_archive.cpp
  vdb_fields.cpp
  vdb_read.cpp
  vdb_write.cpp
  volume.cpp
  ${ISOLUME_ITK_SOURCE}
)
target_include_directories(isolume_readers PUBLIC ${PROJECT_SOURCE_DIR} ${PROJECT_SOURCE_DIR}/src)
target_link_libraries(isolume_readers PUBLIC isolume_sweep PRIVATE isolume_flags OpenVDB::openvdb ZLIB::ZLIB fmt::fmt)
if(ISOLUME_WITH_ITK AND ITK_FOUND)
  # Headers of ITK are not held to this project's warnings; its USE_FILE would change flags for every target.
  target_include_directories(isolume_readers SYSTEM PRIVATE ${ITK_INCLUDE_DIRS})
  target_link_libraries(isolume_readers PRIVATE ${ITK_LIBRARIES})
  target_compile_definitions(isolume_readers PUBLIC ISOLUME_HAVE_ITK)
endif()
