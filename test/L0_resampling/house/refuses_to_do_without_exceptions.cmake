# Has COMPILER look at each public header without exceptions: it says at once that they are needed,
# or the header does without.
cmake_minimum_required(VERSION 3.21)

include(${CMAKE_CURRENT_LIST_DIR}/compiler_and_includes.cmake)
file(GLOB headers RELATIVE ${INCLUDE_DIRECTORY} ${INCLUDE_DIRECTORY}/CGAL/*.h
                                                ${INCLUDE_DIRECTORY}/CGAL/L0_resampling/*.h)
# Those of the device ask for its library first, and rows of a table are no header.
list(FILTER headers EXCLUDE REGEX "CUDA_|_interface.h$")
set(number_of_refused 0)
foreach(header IN LISTS headers)
  execute_process(
    COMMAND ${program} -std=c++17 -fno-exceptions -fsyntax-only -Wfatal-errors ${includes}
            -DCGAL_EIGEN3_ENABLED -include ${header} -x c++ /dev/null
    RESULT_VARIABLE status
    ERROR_VARIABLE errors)
  if(errors MATCHES "compile it without -fno-exceptions")
    math(EXPR number_of_refused "${number_of_refused} + 1")
  elseif(NOT status EQUAL 0)
    message(SEND_ERROR "${header} does not say that it needs exceptions:\n${errors}")
  endif()
endforeach()
if(number_of_refused LESS 10)
  message(SEND_ERROR "only ${number_of_refused} headers need exceptions, this test looks elsewhere")
endif()
