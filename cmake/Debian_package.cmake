# What `cpack` makes: a Debian package of all that is installed. scripts/package.sh makes one for every machine.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME cgal-l0-resampling)
set(CPACK_PACKAGE_VERSION ${PROJECT_VERSION})
set(CPACK_PACKAGE_CONTACT "The CGAL::L0_resampling authors")
set(CPACK_PACKAGE_DESCRIPTION
"Turns raw, noisy, unoriented points into clean, evenly spread, oriented points
of an exact number that keep sharp features: the program l0_resample, the C++
headers of CGAL::l0_resample_point_set() with their CMake package, examples,
and, where they were built, the Python package cgal_l0 and the manual, which is
read from /usr/share/doc/cgal-l0-resampling/html/index.html without a network.")
if(CGAL_L0_WITH_CUDA)
  string(APPEND CPACK_PACKAGE_DESCRIPTION "\n\nThe program uses an NVIDIA device where a driver finds one; to link with the
library for devices takes the CUDA toolkit, which Debian does not have in main.")
endif()
if(CGAL_L0_WITH_NATIVE_INSTRUCTIONS)
  # Other processors may not run it, and nobody shall find that out by a crash.
  string(APPEND CPACK_PACKAGE_VERSION +native)
  string(APPEND CPACK_PACKAGE_DESCRIPTION "\n\nThis build runs on processors as the one of the machine that made it.")
endif()
set(CPACK_STRIP_FILES ON)
set(CPACK_PRE_BUILD_SCRIPTS ${CMAKE_CURRENT_LIST_DIR}/Python_of_Debian.cmake)

set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION math)
# The program needs libraries. Headers and Python package need more, which nobody has to have who only wants the program.
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${PROJECT_BINARY_DIR}/${l0_folder_of_libraries})
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libcgal-dev (>= 5.5), libeigen3-dev (>= 3.3.7), libtbb-dev")
if(TARGET cgal_l0)
  math(EXPR l0_next_python "${Python_VERSION_MINOR} + 1")
  string(APPEND CPACK_DEBIAN_PACKAGE_RECOMMENDS ", python3-numpy, python3 (>= ${Python_VERSION_MAJOR}.${Python_VERSION_MINOR})"
         ", python3 (<< ${Python_VERSION_MAJOR}.${l0_next_python})")
endif()

# Debian's changelog, with the time of SOURCE_DATE_EPOCH where that is set
string(TIMESTAMP l0_date "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file(${CMAKE_CURRENT_LIST_DIR}/changelog.in ${PROJECT_BINARY_DIR}/changelog @ONLY)
find_program(CGAL_L0_GZIP gzip DOC "Compresses the man page")
if(CGAL_L0_GZIP)
  execute_process(COMMAND ${CGAL_L0_GZIP} -9 -n -f ${PROJECT_BINARY_DIR}/changelog
                  COMMAND_ERROR_IS_FATAL ANY)
  install(FILES ${PROJECT_BINARY_DIR}/changelog.gz DESTINATION ${CMAKE_INSTALL_DOCDIR})
endif()
install(FILES ${CMAKE_CURRENT_LIST_DIR}/copyright ${PROJECT_SOURCE_DIR}/CHANGES.md
        DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES ${CMAKE_CURRENT_LIST_DIR}/lintian-overrides
        DESTINATION ${CMAKE_INSTALL_DATADIR}/lintian/overrides RENAME cgal-l0-resampling)
# Licenses of the headers that are compiled in. The libraries that are loaded have theirs in packages
# of their own, on which this one depends. They are looked for where something is installed, as who
# only builds has no use for them.
if(CGAL_L0_BUILD_TOOL)
  set(l0_licenses ${PROJECT_BINARY_DIR}/licenses)
  install(CODE "
    file(STRINGS \"${PROJECT_BINARY_DIR}/headers_of_others.txt\" headers)
    file(REMOVE_RECURSE \"${l0_licenses}\")
    execute_process(COMMAND \"${PROJECT_SOURCE_DIR}/scripts/library_licenses.sh\" \"${l0_licenses}\" \${headers}
                    RESULT_VARIABLE status OUTPUT_QUIET ERROR_VARIABLE message)
    if(NOT status EQUAL 0)
      file(REMOVE_RECURSE \"${l0_licenses}\")
      message(STATUS \"NOTICE: a Debian package would lack licenses of headers. \${message}\")
    endif()")
  install(DIRECTORY ${l0_licenses} DESTINATION ${CMAKE_INSTALL_DOCDIR} OPTIONAL)
endif()
include(CPack)
