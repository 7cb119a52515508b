# Sets `program` to the path of COMPILER, empty if it is not installed, and `includes` to the
# options that name the folders of the headers: INCLUDE_DIRECTORY, CGAL_INCLUDE_DIRECTORIES and
# SYSTEM_INCLUDE_DIRECTORIES.
find_program(program NAMES ${COMPILER})
if(NOT program)
  set(program "")
  message(STATUS "${COMPILER} is not installed")
endif()

set(includes -I ${INCLUDE_DIRECTORY})
foreach(directory IN LISTS CGAL_INCLUDE_DIRECTORIES SYSTEM_INCLUDE_DIRECTORIES)
  if(NOT directory STREQUAL "/usr/include")   # is searched anyway, and only in its own place
    list(APPEND includes -isystem ${directory})
  endif()
endforeach()
