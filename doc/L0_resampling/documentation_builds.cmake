# Builds the manual and looks for its pages:
#   cmake -DBUILD_DIRECTORY=<build> -DMANUAL_DIRECTORY=<where the target doc works>
#         -P documentation_builds.cmake

cmake_minimum_required(VERSION 3.21)

execute_process(COMMAND ${CMAKE_COMMAND} --build ${BUILD_DIRECTORY} --target doc
                RESULT_VARIABLE status)
if(EXISTS ${MANUAL_DIRECTORY}/warnings.txt)
  file(READ ${MANUAL_DIRECTORY}/warnings.txt warnings)
endif()
if(NOT status EQUAL 0 OR warnings)
  message(FATAL_ERROR "The manual does not build without a warning:\n${warnings}")
endif()

set(pages
  index L0_resampling_mathematics L0_resampling_accuracy_and_speed L0_resampling_extending
  L0_resampling_promises L0_resampling_python L0_resampling_tool L0_resampling_recipes
  L0_resampling_glossary bgl_namedparameters citelist examples
  group__PkgL0ResamplingRef group__PkgL0ResamplingConcepts classL0ResamplingSolverTraits
  structCGAL_1_1CUDA__tag)
foreach(name IN ITEMS Block__chebyshev__solver__traits Block__conjugate__gradient__solver__traits
                      Eigen__cholesky__solver__traits
                      Eigen__least__squares__solver__traits
                      CUDA__least__squares__solver__traits CUDA__resampler
                      Solver__error Device__error)
  list(APPEND pages classCGAL_1_1L0__resampling_1_1${name})
endforeach()
foreach(name IN ITEMS Report Stage__report Iteration__report Solver__report Quadratic__problem
                      Explicit__rows Neighborhoods__view)
  list(APPEND pages structCGAL_1_1L0__resampling_1_1${name})
endforeach()
foreach(page IN LISTS pages)
  if(NOT EXISTS ${MANUAL_DIRECTORY}/html/${page}.html)
    message(SEND_ERROR "There is no page ${page}.html.")
  endif()
endforeach()

# The function itself, with its parameters, and what the code says of them
foreach(words IN ITEMS "l0_resample_point_set" "sharpness_angle" "std::invalid_argument")
  file(STRINGS ${MANUAL_DIRECTORY}/html/group__PkgL0ResamplingRef.html lines REGEX "${words}")
  if(NOT lines)
    message(SEND_ERROR "The reference manual does not know ${words}.")
  endif()
endforeach()
