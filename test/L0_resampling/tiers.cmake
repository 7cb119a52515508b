# Which tests of this folder a build has: those of the tier CGAL_L0_TEST_TIER, and of the tiers
# before it. What other folders build has its tests with it. The table tiers.csv names the tier of
# each test, which becomes its label in CTest.
set(CGAL_L0_TEST_TIER full CACHE STRING
    "Tests to build: core (the package), user (all that users rely on) or full")
set(l0_all_tiers core user full)
set_property(CACHE CGAL_L0_TEST_TIER PROPERTY STRINGS ${l0_all_tiers})
list(FIND l0_all_tiers "${CGAL_L0_TEST_TIER}" last)
if(last EQUAL -1)
  message(FATAL_ERROR "CGAL_L0_TEST_TIER is ${CGAL_L0_TEST_TIER}, and has to be one of"
                      " ${l0_all_tiers}.")
endif()
math(EXPR number "${last} + 1")
list(SUBLIST l0_all_tiers 0 ${number} l0_tiers)

set(l0_table_of_tiers ${CMAKE_CURRENT_LIST_DIR}/tiers.csv)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${l0_table_of_tiers})
set(l0_rows_of_tiers "")   # each PATTERN,TIER
file(STRINGS ${l0_table_of_tiers} rows)
list(POP_FRONT rows)
foreach(row IN LISTS rows)
  string(REGEX REPLACE "^([^,]+,[^,]+),.*$" "\\1" row "${row}")
  string(REGEX REPLACE "([+.])" "[\\1]" row "${row}")
  string(REPLACE "*" ".*" row "${row}")
  list(APPEND l0_rows_of_tiers ${row})
endforeach()

function(l0_get_tier test result)
  set(tiers "")
  foreach(row IN LISTS l0_rows_of_tiers)
    string(REPLACE "," ";" row ${row})
    list(GET row 0 pattern)
    if(test MATCHES "^${pattern}$")
      list(GET row 1 tier)
      list(APPEND tiers ${tier})
    endif()
  endforeach()
  list(LENGTH tiers number)
  if(NOT number EQUAL 1 OR NOT tiers IN_LIST l0_all_tiers)
    message(FATAL_ERROR "${l0_table_of_tiers}: the test ${test} needs one row with one of the tiers"
                        " ${l0_all_tiers}, and has \"${tiers}\".")
  endif()
  set(${result} ${tiers} PARENT_SCOPE)
endfunction()

# Labels the tests of a folder: its last call. Tests that are named look at sources, and run nothing
# that is built, so that they need not be run for other compilers or sanitizers once more.
function(l0_label_tests)
  get_property(tests DIRECTORY PROPERTY TESTS)
  foreach(test IN LISTS ARGN)
    if(TEST ${test})
      set_property(TEST ${test} APPEND PROPERTY LABELS sources)
    endif()
  endforeach()
  foreach(test IN LISTS tests)
    l0_get_tier(${test} tier)
    set_property(TEST ${test} APPEND PROPERTY LABELS ${tier})
  endforeach()
endfunction()
