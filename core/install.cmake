# cmake --install: the library with its headers, for find_package(chebnet), and the program.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)
set(package_folder ${CMAKE_INSTALL_LIBDIR}/cmake/chebnet)
install(TARGETS chebnet EXPORT chebnet)
# In a folder of their own: the names of the rooms, base/ or io/, are nobody's.
install(DIRECTORY core/ DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/chebnet FILES_MATCHING PATTERN "*.h" PATTERN cli EXCLUDE)
install(EXPORT chebnet NAMESPACE chebnet:: FILE chebnet-targets.cmake DESTINATION ${package_folder})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/chebnet-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES core/chebnet-config.cmake ${CMAKE_BINARY_DIR}/chebnet-config-version.cmake DESTINATION ${package_folder})
install(TARGETS chebnet_cli)
