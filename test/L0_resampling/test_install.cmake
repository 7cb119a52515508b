# Installs the build in BUILD_DIRECTORY to a folder of its own, and builds and runs a project that
# only knows that folder:
#   cmake -DBUILD_DIRECTORY=... -DSCRATCH=... -DGENERATOR=... -P test_install.cmake

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
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${SCRATCH}/build -G ${GENERATOR}
    -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH=${SCRATCH}/installed)
# A build with CUDA is of use also where there is no CUDA toolkit.
run(${CMAKE_COMMAND} -S ${CMAKE_CURRENT_LIST_DIR}/consumer -B ${SCRATCH}/without_cuda
    -G ${GENERATOR} -DCMAKE_PREFIX_PATH=${SCRATCH}/installed
    -DCMAKE_DISABLE_FIND_PACKAGE_CUDAToolkit=ON)
run(${CMAKE_COMMAND} --build ${SCRATCH}/build)
run(${SCRATCH}/build/consumer)
run(${SCRATCH}/build/consumer_of_compiled)
if(EXISTS ${SCRATCH}/installed/bin/l0_resample)
  run(${SCRATCH}/installed/bin/l0_resample --version)
  foreach(file IN ITEMS share/man/man1/l0_resample.1 share/bash-completion/completions/l0_resample)
    if(NOT EXISTS ${SCRATCH}/installed/${file})
      message(FATAL_ERROR "${file} is not installed")
    endif()
  endforeach()
endif()
