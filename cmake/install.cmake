# `cmake --install` and, for those who use the result, find_package(evenmesh).
include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/evenmesh)

install(TARGETS evenmesh EXPORT evenmesh
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR}
  FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
install(EXPORT evenmesh FILE evenmeshTargets.cmake NAMESPACE evenmesh::
  DESTINATION ${package_dir})

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/evenmeshConfig.cmake.in
  ${PROJECT_BINARY_DIR}/evenmeshConfig.cmake INSTALL_DESTINATION ${package_dir}
  NO_SET_AND_CHECK_MACRO)
# Before 1.0 a minor version may change the interface.
write_basic_package_version_file(${PROJECT_BINARY_DIR}/evenmeshConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/evenmeshConfig.cmake ${PROJECT_BINARY_DIR}/evenmeshConfigVersion.cmake
  DESTINATION ${package_dir})

install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

if(TARGET evenmesh_app)
  install(TARGETS evenmesh_app RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()
