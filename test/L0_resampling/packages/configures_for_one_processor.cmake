# Configures SOURCE in SCRATCH for one kind of processor, as packages for others than x86-64 are:
# the loader has nothing to choose from. The tool finds what a wheel brings of other libraries:
#   cmake -DSOURCE=... -DSCRATCH=... -DGENERATOR=... -DCGAL_DIR=... -DFLAGS=<of the compiler>
#         -P configures_for_one_processor.cmake

execute_process(
  COMMAND ${CMAKE_COMMAND} -G ${GENERATOR} -S ${SOURCE} -B ${SCRATCH} -DCGAL_DIR=${CGAL_DIR}
          -DCGAL_L0_WITH_CUDA=OFF -DCGAL_L0_WITH_PYTHON=OFF -DCGAL_L0_WITH_NATIVE_INSTRUCTIONS=OFF
          -DCMAKE_CXX_FLAGS=${FLAGS}
  COMMAND_ERROR_IS_FATAL ANY)
file(READ ${SCRATCH}/cmake/cmake_install.cmake install)
if(NOT install MATCHES "NEW_RPATH [^\n]*ORIGIN/\\.\\./libexec/cgal-l0-resampling")
  message(FATAL_ERROR "The tool does not look where a wheel has libraries.")
endif()
