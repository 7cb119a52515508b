# Has COMPILER look at SOURCE in C++ STANDARD with all that it warns of, and fails on a warning.
# Headers of CGAL come from CGAL_INCLUDE_DIRECTORIES only: those that another CGAL has, and this one
# has not any more, would be found silently.
include(${CMAKE_CURRENT_LIST_DIR}/compiler_and_includes.cmake)
if(NOT program)
  return()
endif()
file(MAKE_DIRECTORY ${SCRATCH})
execute_process(
  COMMAND ${program} -std=c++${STANDARD} -fsyntax-only -Wall -Wextra -Wpedantic -Wconversion -Werror
          ${includes} -DCGAL_LINKED_WITH_TBB -DCGAL_EIGEN3_ENABLED -DCGAL_L0_LINKED_WITH_CUDA
          -MD -MF ${SCRATCH}/headers.d ${SOURCE}
  COMMAND_ERROR_IS_FATAL ANY)

file(READ ${SCRATCH}/headers.d headers)
string(REGEX MATCHALL "[^ \\\n]*/CGAL/[^ \\\n]*" headers "${headers}")
list(LENGTH headers number_of_headers)
list(APPEND CGAL_INCLUDE_DIRECTORIES ${INCLUDE_DIRECTORY})
foreach(directory IN LISTS CGAL_INCLUDE_DIRECTORIES)
  file(REAL_PATH ${directory} real_directory)   # which compilers name, where it is the shorter one
  list(FILTER headers EXCLUDE REGEX "^${real_directory}/")
  list(FILTER headers EXCLUDE REGEX "^${directory}/")
endforeach()
if(number_of_headers LESS 100)
  message(FATAL_ERROR
          "only ${number_of_headers} headers are known, this test does not look where it should")
endif()
if(headers)
  list(JOIN headers "\n  " lines)
  message(FATAL_ERROR "from another CGAL:\n  ${lines}")
endif()
