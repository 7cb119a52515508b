# Installs the build in BUILD_DIRECTORY to a folder of its own, and builds and runs projects that
# only know that folder, one of them with the program of README.md in SOURCE:
#   cmake -DBUILD_DIRECTORY=... -DSCRATCH=... -DGENERATOR=... -DCGAL_DIR=... -DPYTHON=...
#         -DSOURCE=... -DEIGEN_INCLUDE_DIRECTORY=... -P test_install.cmake

cmake_minimum_required(VERSION 3.21)

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status
                  OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN} ended with status ${status}:\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE ${SCRATCH})
run(${CMAKE_COMMAND} --install ${BUILD_DIRECTORY} --prefix ${SCRATCH}/installed)
set(options -G ${GENERATOR} -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH=${SCRATCH}/installed
    -DCGAL_DIR=${CGAL_DIR} "-DCMAKE_CXX_FLAGS_RELEASE=-O0 -DNDEBUG")   # nothing large runs
# A build with CUDA is of use also where there is no CUDA toolkit.
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${SCRATCH}/without_cuda ${options}
    -DCMAKE_DISABLE_FIND_PACKAGE_CUDAToolkit=ON)
# So is one with another Eigen than that of its user.
include(${CMAKE_CURRENT_LIST_DIR}/eigen_stand_in.cmake)
write_eigen_stand_in(5.0.1 ${SCRATCH}/eigen)
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${SCRATCH}/with_eigen_5 ${options}
    -DEigen3_DIR=${SCRATCH}/eigen)

# What README shows, with the compiled library, which brings the target of the headers with it
set(readme ${SCRATCH}/readme)
run(${PYTHON} ${CMAKE_CURRENT_LIST_DIR}/extract_readme_project.py ${SOURCE}/README.md ${readme})
run(${CMAKE_COMMAND} -S ${readme} -B ${readme}/build ${options})
run(${CMAKE_COMMAND} --build ${readme}/build)
file(COPY_FILE ${SOURCE}/data/bracket_noisy.ply ${readme}/scan.ply)
run(${CMAKE_COMMAND} -E chdir ${readme} build/clean_scan)
file(STRINGS ${readme}/clean.ply header LIMIT_COUNT 20 REGEX "^(element|property) ")
if(NOT header MATCHES "^element vertex 20000;.*property [a-z]+ nz")
  message(FATAL_ERROR "clean.ply of the program of README has the header ${header}")
endif()

if(EXISTS ${SCRATCH}/installed/bin/l0_resample)
  run(${SCRATCH}/installed/bin/l0_resample --version)
  foreach(file IN ITEMS share/man/man1/l0_resample.1* share/bash-completion/completions/l0_resample)
    file(GLOB installed ${SCRATCH}/installed/${file})
    if(NOT installed)
      message(FATAL_ERROR "${file} is not installed")
    endif()
  endforeach()
endif()
