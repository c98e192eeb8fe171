# Installs what was built into an empty folder and builds and runs another project against it.
#   cmake -D BUILD=<build folder of chebnet> -D CXX=<its compiler> -P try.cmake
set(place ${BUILD}/package)
file(REMOVE_RECURSE ${place})
foreach(step
        "--install;${BUILD};--prefix;${place}/prefix"
        "-S;${CMAKE_CURRENT_LIST_DIR};-B;${place}/guest;-DCMAKE_PREFIX_PATH=${place}/prefix;-DCMAKE_CXX_COMPILER=${CXX}"
        "--build;${place}/guest")
    execute_process(COMMAND ${CMAKE_COMMAND} ${step} OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endforeach()
execute_process(COMMAND ${place}/guest/guest COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${place}/prefix/bin/chebnet --version COMMAND_ERROR_IS_FATAL ANY)
