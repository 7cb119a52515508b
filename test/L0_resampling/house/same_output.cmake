# Fails unless the programs FIRST and SECOND, with the argument ARGUMENT, write the same to standard
# output, and something:
#   cmake -DFIRST=... -DSECOND=... -DARGUMENT=... -P same_output.cmake

foreach(program IN ITEMS FIRST SECOND)
  execute_process(COMMAND ${${program}} ${ARGUMENT} OUTPUT_VARIABLE output_of_${program}
                  COMMAND_ERROR_IS_FATAL ANY)
endforeach()
if(output_of_FIRST STREQUAL "" OR NOT output_of_FIRST STREQUAL output_of_SECOND)
  message(FATAL_ERROR "The output of ${FIRST} and of ${SECOND} differs, or is empty.")
endif()
