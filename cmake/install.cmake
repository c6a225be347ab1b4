# What `cmake --install` puts where: the library, its headers and its CMake
# package. cli/ installs the program, src/formats/ its OpenCV module.
include(CMakePackageConfigHelpers)

set(unstep_package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/unstep)

install(TARGETS unstep EXPORT unstepTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/src/include/unstep
  DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT unstepTargets NAMESPACE unstep::
  DESTINATION ${unstep_package_dir})

# A static library hands its private dependencies on to whoever links it.
get_target_property(unstep_type unstep TYPE)
set(UNSTEP_IS_STATIC OFF)
if(unstep_type STREQUAL "STATIC_LIBRARY")
  set(UNSTEP_IS_STATIC ON)
endif()
configure_package_config_file(
  ${PROJECT_SOURCE_DIR}/cmake/unstepConfig.cmake.in
  ${PROJECT_BINARY_DIR}/unstepConfig.cmake
  INSTALL_DESTINATION ${unstep_package_dir})
# Before 1.0 a minor version may change the interface.
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/unstepConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/unstepConfig.cmake
  ${PROJECT_BINARY_DIR}/unstepConfigVersion.cmake
  DESTINATION ${unstep_package_dir})

install(FILES ${PROJECT_SOURCE_DIR}/LICENSE
  DESTINATION ${CMAKE_INSTALL_DOCDIR})
