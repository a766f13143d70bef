# Not find_package(OpenImageIO): in Debian 12 its imported target names folders of OpenCV and Imath's Python that its own
# package does not bring, so that configuring fails.
find_path(ISOLUME_OIIO_INCLUDE_DIR OpenImageIO/imageio.h REQUIRED)
find_library(ISOLUME_OIIO_LIBRARY OpenImageIO REQUIRED)
find_library(ISOLUME_OIIO_UTIL_LIBRARY OpenImageIO_Util REQUIRED)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
find_package(Boost REQUIRED)
include(GNUInstallDirs)

add_library(isolume_writers STATIC
  checksum.cpp
  image_codec.cpp
  image_read.cpp
  image_write.cpp
  output_file.cpp
  png_text.cpp
  srgb.cpp
  unfinished_file.cpp
)
target_include_directories(isolume_writers PUBLIC ${PROJECT_SOURCE_DIR})
target_compile_definitions(isolume_writers PRIVATE ISOLUME_INSTALL_LIBDIR="${CMAKE_INSTALL_LIBDIR}")
target_link_libraries(isolume_writers
  PUBLIC isolume_flags glm::glm
  PRIVATE isolume_sweep fmt::fmt OpenSSL::Crypto Boost::boost Threads::Threads ${CMAKE_DL_LIBS})

# Loaded at run time from lib/isolume, beside or above the program: see image_codec.h.
add_library(isolume_image_codec MODULE image_codec_module.cpp)
target_include_directories(isolume_image_codec PRIVATE ${PROJECT_SOURCE_DIR})
target_include_directories(isolume_image_codec SYSTEM PRIVATE ${ISOLUME_OIIO_INCLUDE_DIR})
target_link_libraries(isolume_image_codec PRIVATE
  isolume_flags glm::glm ${ISOLUME_OIIO_LIBRARY} ${ISOLUME_OIIO_UTIL_LIBRARY})
set_target_properties(isolume_image_codec PROPERTIES
  PREFIX "" LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/lib/isolume)
install(TARGETS isolume_image_codec LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/isolume)
add_dependencies(isolume_writers isolume_image_codec)
