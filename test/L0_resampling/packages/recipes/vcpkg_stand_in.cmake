# Carries out a port as vcpkg does it, for one configuration, with stand-ins for its functions:
#   cmake -DPORT_DIRECTORY=... -DSCRATCH=... -DGENERATOR=... -DCGAL_DIR=... -DLIBRARY=...
#         -P vcpkg_stand_in.cmake
# What it installs comes to SCRATCH/installed, with the CMake package in share/, where vcpkg has it.
cmake_minimum_required(VERSION 3.21)

function(run)
  execute_process(COMMAND ${ARGN} COMMAND_ERROR_IS_FATAL ANY OUTPUT_QUIET)
endfunction()

function(vcpkg_check_linkage linkage)
  if(NOT linkage STREQUAL "ONLY_STATIC_LIBRARY")
    message(FATAL_ERROR "the library is static, and the port says ${linkage}")
  endif()
endfunction()

function(vcpkg_cmake_configure)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "SOURCE_PATH" "OPTIONS")
  # vcpkg refuses a port with options that the project does not know.
  execute_process(
    COMMAND ${CMAKE_COMMAND} -S ${arg_SOURCE_PATH} -B ${SCRATCH}/build -G ${GENERATOR}
            ${arg_OPTIONS} -DCMAKE_BUILD_TYPE=Release
            -DCGAL_DIR=${CGAL_DIR}
            -DCMAKE_INSTALL_PREFIX=${CURRENT_PACKAGES_DIR} -DCMAKE_INSTALL_LIBDIR=lib
    COMMAND_ERROR_IS_FATAL ANY ERROR_VARIABLE warnings OUTPUT_QUIET)
  if(arg_UNPARSED_ARGUMENTS OR warnings MATCHES "variables were not used")
    message(FATAL_ERROR "${arg_UNPARSED_ARGUMENTS} ${warnings}")
  endif()
endfunction()

# Does what CMake wants to do, but for the compiler: LIBRARY is the same, built already.
function(vcpkg_cmake_install)
  set(place src/CGAL_L0_resampling_compiled/libCGAL_L0_resampling_compiled.a)
  execute_process(COMMAND ${CMAKE_COMMAND} --build ${SCRATCH}/build -- -n
                  OUTPUT_VARIABLE steps COMMAND_ERROR_IS_FATAL ANY)
  foreach(step IN ITEMS without_tag.cpp sequential.cpp libCGAL_L0_resampling_compiled.a)
    if(NOT steps MATCHES "${step}")
      message(FATAL_ERROR "${step} is no part of the build:\n${steps}")
    endif()
  endforeach()
  configure_file(${LIBRARY} ${SCRATCH}/build/${place} COPYONLY)
  run(${CMAKE_COMMAND} --install ${SCRATCH}/build)
endfunction()

function(vcpkg_cmake_config_fixup)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "PACKAGE_NAME;CONFIG_PATH" "")
  set(folder ${CURRENT_PACKAGES_DIR}/share/${arg_PACKAGE_NAME})
  file(RENAME ${CURRENT_PACKAGES_DIR}/${arg_CONFIG_PATH} ${folder})
  file(GLOB files ${folder}/*.cmake)
  foreach(file IN LISTS files)   # the prefix is two folders above now
    file(READ ${file} text)
    string(REGEX REPLACE "(get_filename_component\\(_IMPORT_PREFIX [^\n]*\n)+"
           "cmake_path(SET _IMPORT_PREFIX NORMALIZE \"\${CMAKE_CURRENT_LIST_DIR}/../..\")\n"
           text "${text}")
    file(WRITE ${file} "${text}")
  endforeach()
endfunction()

function(vcpkg_install_copyright)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "" "FILE_LIST")
  configure_file(${arg_FILE_LIST} ${CURRENT_PACKAGES_DIR}/share/${PORT}/copyright COPYONLY)
endfunction()

cmake_path(GET PORT_DIRECTORY FILENAME PORT)
set(CURRENT_PORT_DIR ${PORT_DIRECTORY})
set(CURRENT_PACKAGES_DIR ${SCRATCH}/installed)
include(${PORT_DIRECTORY}/portfile.cmake)
if(NOT EXISTS ${CURRENT_PACKAGES_DIR}/share/${PORT}/copyright)
  message(FATAL_ERROR "the port installs no copyright")
endif()
