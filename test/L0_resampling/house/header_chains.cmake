# Which headers can be compiled one after the other, and each as if it were alone.
#
# A header may follow those that it includes anyway: they bring it nothing that it has not asked
# for. So a chain, in which each header includes the one before it, is one source file with the
# verdict of as many as the chain has headers. CMake finds the chains when it configures.

# Appends to `order` what `header` includes of ours, each after what it includes itself, and then
# `header`; sets closure_of_<header> for each of them.
function(l0_visit_header header)
  if(DEFINED closure_of_${header})
    return()
  endif()
  file(STRINGS ${PROJECT_SOURCE_DIR}/include/${header} lines
       REGEX "^ *# *include <CGAL/(L0_resampling/|l0_)")
  set(closure "")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE ".*<(.*)>.*" "\\1" included "${line}")
    if(included IN_LIST l0_headers)
      l0_visit_header(${included})
      list(APPEND closure ${included} ${closure_of_${included}})
    endif()
  endforeach()
  list(REMOVE_DUPLICATES closure)
  list(APPEND order ${header})
  set(closure_of_${header} "${closure}")
  foreach(known IN LISTS order)
    set(closure_of_${known} "${closure_of_${known}}" PARENT_SCOPE)
  endforeach()
  set(order "${order}" PARENT_SCOPE)
endfunction()

# Sets chain_<k> for each k of 0, 1, ... `number_of_chains` - 1. They hold each of `l0_headers`
# once.
function(l0_find_header_chains)
  set(order "")
  foreach(header IN LISTS l0_headers)
    l0_visit_header(${header})
  endforeach()
  set(ends "")   # the last header of each chain
  foreach(header IN LISTS order)
    set(best -1)
    set(length_of_best -1)
    set(k 0)
    foreach(end IN LISTS ends)
      list(LENGTH closure_of_${end} length)
      if(end IN_LIST closure_of_${header} AND length GREATER length_of_best)
        set(best ${k})
        set(length_of_best ${length})
      endif()
      math(EXPR k "${k} + 1")
    endforeach()
    if(best EQUAL -1)
      list(APPEND ends ${header})
      set(chain_${k} ${header})
    else()
      list(REMOVE_AT ends ${best})
      list(INSERT ends ${best} ${header})
      list(APPEND chain_${best} ${header})
    endif()
  endforeach()
  list(LENGTH ends number_of_chains)
  math(EXPR last "${number_of_chains} - 1")
  foreach(k RANGE ${last})
    set(chain_${k} "${chain_${k}}" PARENT_SCOPE)
  endforeach()
  set(number_of_chains ${number_of_chains} PARENT_SCOPE)
endfunction()
