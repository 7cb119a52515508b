# Each patch of this folder applies to the tree:
# cmake -DPATCH=<program> -DTREE=<source directory> -P patches_apply.cmake
#
# To the letter, but for the lines' numbers: a patch that fits only roughly might switch off something else.

cmake_minimum_required(VERSION 3.21)

file(GLOB patches ${CMAKE_CURRENT_LIST_DIR}/*.patch)
if(NOT patches)
  message(FATAL_ERROR "There are no patches.")
endif()
foreach(patch IN LISTS patches)
  execute_process(COMMAND ${PATCH} -d ${TREE} -p1 -f -F0 --dry-run -i ${patch}
                  RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if(NOT status EQUAL 0)
    message(SEND_ERROR "${patch} does not apply:\n${said}")
  endif()
  file(STRINGS ${patch} first_line LIMIT_COUNT 1)
  if(NOT first_line MATCHES "^# .")
    message(SEND_ERROR "${patch} does not say in its first line what is left.")
  endif()
endforeach()
