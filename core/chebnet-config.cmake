# What find_package(chebnet) reads: the library is the target chebnet::chebnet.
include(CMakeFindDependencyMacro)
find_dependency(Eigen3 3.4 NO_MODULE)
include(${CMAKE_CURRENT_LIST_DIR}/chebnet-targets.cmake)
