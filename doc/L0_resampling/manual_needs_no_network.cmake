# Moves a copy of the manual elsewhere, where only relative names lead to its files, and looks
# whether it loads anything from outside; then the same for the manual that a machine without
# MathJax gets:
#   cmake -DMANUAL_DIRECTORY=<where the target doc works> -DSCRATCH=<folder> -DPYTHON=<interpreter>
#         [-DMATHJAX=<its folder>] -P manual_needs_no_network.cmake

cmake_minimum_required(VERSION 3.21)

set(tools ${CMAKE_CURRENT_LIST_DIR}/tools)
function(run)
  execute_process(COMMAND ${PYTHON} -B ${ARGN} RESULT_VARIABLE status ERROR_VARIABLE errors)
  if(NOT status EQUAL 0)
    message(SEND_ERROR "${ARGN}:\n${errors}")
  endif()
endfunction()

file(REMOVE_RECURSE ${SCRATCH})
file(COPY ${MANUAL_DIRECTORY}/html DESTINATION ${SCRATCH})
if(MATHJAX)
  run(${tools}/check_offline.py ${SCRATCH}/html --formulas drawn)
  file(REMOVE_RECURSE ${SCRATCH}/html/mathjax)
  run(${tools}/place_formulas.py ${SCRATCH}/html)
endif()
run(${tools}/check_offline.py ${SCRATCH}/html --formulas text)
