# Uses evenmesh from another project and runs the result.
#
# cmake -D MODE=installed|subdirectory -D BUILD_DIR=... -D WORK_DIR=... -D GENERATOR=...
#       -D CXX_COMPILER=... -P run_consumer.cmake
# BUILD_DIR is a build of evenmesh, WORK_DIR is emptied first.
file(REMOVE_RECURSE ${WORK_DIR})

function(run)
  execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

set(options -G ${GENERATOR} -D CMAKE_CXX_COMPILER=${CXX_COMPILER} -D CMAKE_BUILD_TYPE=Debug)
if(MODE STREQUAL "installed")
  run(${CMAKE_COMMAND} --install ${BUILD_DIR} --prefix ${WORK_DIR}/prefix)
  list(APPEND options -D CMAKE_PREFIX_PATH=${WORK_DIR}/prefix)
else()
  list(APPEND options -D CONSUMER_ADDS_SUBDIRECTORY=ON)
endif()

run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/../consumer -B ${WORK_DIR}/build ${options})
if(MODE STREQUAL "subdirectory" AND GENERATOR STREQUAL "Ninja")
  # The library is built and linked by every other test: that the headers are found will do.
  run(${CMAKE_COMMAND} --build ${WORK_DIR}/build --target CMakeFiles/consumer.dir/main.cpp.o)
  return()
endif()
run(${CMAKE_COMMAND} --build ${WORK_DIR}/build --target consumer)
run(${WORK_DIR}/build/consumer)
