# Versions of Eigen that are accepted and refused, by stand-ins for what Eigen installs:
#   cmake -DSOURCE=... -DSCRATCH=... -DGENERATOR=... -DCGAL_DIR=... -DEIGEN_INCLUDE_DIRECTORY=...
#         -P test_eigen_versions.cmake
cmake_minimum_required(VERSION 3.21)
include(${CMAKE_CURRENT_LIST_DIR}/eigen_stand_in.cmake)

file(REMOVE_RECURSE ${SCRATCH})
foreach(version IN ITEMS 5.0.1 3.3.7 3.3.6)
  write_eigen_stand_in(${version} ${SCRATCH}/eigen_${version})
  execute_process(
    COMMAND ${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumer_of_sources
            -B ${SCRATCH}/build_${version} -G ${GENERATOR} -DL0_SOURCE=${SOURCE}
            -DCGAL_DIR=${CGAL_DIR} -DCGAL_L0_WITH_CUDA=OFF
            -DEigen3_DIR=${SCRATCH}/eigen_${version}
    RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  set(is_refused OFF)
  if(status AND output MATCHES "Eigen 3.3.7 or later is needed, and the version \"3.3.6\"")
    set(is_refused ON)
  endif()
  if((version STREQUAL "3.3.6" AND NOT is_refused)
     OR (NOT version STREQUAL "3.3.6" AND NOT status EQUAL 0))
    message(FATAL_ERROR "Eigen ${version}: status ${status}\n${output}")
  endif()
endforeach()
