# Install rules and the package file, so that find_package(isolume) works.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

install(TARGETS isolume RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(TARGETS isolume_sweep isolume_reference isolume_raymarch isolume_shaders isolume_glad isolume_flags EXPORT isolumeTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY sweep raymarch shaders DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/isolume FILES_MATCHING PATTERN "*.h")
install(EXPORT isolumeTargets NAMESPACE isolume:: DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/isolume)
configure_package_config_file(scripts/cmake/isolumeConfig.cmake.in ${CMAKE_CURRENT_BINARY_DIR}/isolumeConfig.cmake
  INSTALL_DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/isolume)
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/isolumeConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/isolumeConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/isolumeConfigVersion.cmake
  DESTINATION ${CMAKE_INSTALL_LIBDIR}/cmake/isolume)
