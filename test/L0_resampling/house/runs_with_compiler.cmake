# Compiles each of SOURCES, tests of formulas that take seconds, by COMPILER in C++ STANDARD, and
# runs it: that a compiler has nothing to say does not mean that its programs do what they should.
include(${CMAKE_CURRENT_LIST_DIR}/compiler_and_includes.cmake)
if(NOT program)
  return()
endif()
file(MAKE_DIRECTORY ${SCRATCH})
cmake_path(SET tests NORMALIZE ${CMAKE_CURRENT_LIST_DIR}/..)
foreach(source IN LISTS SOURCES)
  execute_process(
    COMMAND ${program} -std=c++${STANDARD} -O2 ${includes} -I${tests} -DCGAL_EIGEN3_ENABLED
            ${tests}/${source} -o ${SCRATCH}/program
    COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${SCRATCH}/program COMMAND_ERROR_IS_FATAL ANY)
endforeach()
