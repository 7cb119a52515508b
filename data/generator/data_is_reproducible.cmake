# Runs MAKE_SHAPES into the folder WRITTEN and compares every file with the one in KEPT.

file(MAKE_DIRECTORY "${WRITTEN}")
execute_process(COMMAND "${MAKE_SHAPES}" "${WRITTEN}" RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "make_shapes failed: ${status}")
endif()

foreach(folder IN ITEMS "${WRITTEN}" "${KEPT}")
  file(GLOB files RELATIVE "${folder}" "${folder}/*.off" "${folder}/*.ply")
  list(APPEND names ${files})
endforeach()
list(REMOVE_DUPLICATES names)
if(NOT names)
  message(FATAL_ERROR "make_shapes wrote nothing")
endif()

foreach(name IN LISTS names)
  execute_process(COMMAND "${CMAKE_COMMAND}" -E compare_files "${WRITTEN}/${name}" "${KEPT}/${name}"
                  RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(SEND_ERROR "${name} differs from what the generator writes, or one of the two is missing")
  endif()
endforeach()
