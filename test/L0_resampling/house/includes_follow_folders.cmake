# Checks who includes whom:  cmake -DINCLUDE_DIRECTORY=<include> -P includes_follow_folders.cmake
#
# A header includes headers of its own folder and of the folders before it. Stages do not include
# each other: the folders after theirs join them and pass the results of one to the next. Nothing
# under internal/ includes a solver, which is a template argument. Only the interface knows of
# CGAL's kernels and property maps.

cmake_minimum_required(VERSION 3.21)

# Public headers, which have no folder, stand where their contents belong.
set(order words core kernels plan device search cloud normals samples energy solvers orientation
          driver creases tiles interface calls)
set(words tags.h Solver_report.h Quadratic_problem.h Report.h warnings.h Source_box.h)
set(solvers Block_chebyshev_solver_traits.h Block_conjugate_gradient_solver_traits.h
            Eigen_cholesky_solver_traits.h Eigen_least_squares_solver_traits.h
            CUDA_least_squares_solver_traits.h)
set(interface ../license/L0_resampling.h Crease.h named_parameters_interface.h named_parameters.h)
set(calls CUDA_resampler.h ../l0_resample_point_set.h ../l0_orient_normals.h Tile_result.h
          Tiled_resampling.h ../l0_resample_tiles.h)

# What a call passes, one after another; what they share stands in other headers.
set(stages
  cloud/extents cloud/estimate_scales cloud/estimate_scale_field cloud/find_outliers
  cloud/density_weights cloud/areas_of_points cloud/separate_coincident_points
  normals/estimate_pca_normals normals/filter_normals normals/refit_normals
  samples/initialize_samples samples/fit_compatible_points samples/tangential_repulsion
  samples/project_to_local_quadrics samples/share_points samples/fit_disks
  samples/keep_clear_of_creases samples/estimate_feature_confidences
  energy/collapse_fit_term energy/Fit_rows energy/pair_terms
  orientation/orient_normals search/nearest_input_points)

set(kernel_free_headers CGAL/tags.h CGAL/assertions.h)   # all that the others may have of CGAL

file(GLOB_RECURSE headers RELATIVE ${INCLUDE_DIRECTORY} ${INCLUDE_DIRECTORY}/*.h)
if(NOT headers)
  message(FATAL_ERROR "There are no headers in '${INCLUDE_DIRECTORY}'.")
endif()

# The place of each header in the order
foreach(folder IN LISTS order)
  list(FIND order ${folder} place)
  foreach(header IN LISTS ${folder})
    string(REGEX REPLACE "^L0_resampling/../" "" header "L0_resampling/${header}")
    if(NOT CGAL/${header} IN_LIST headers)
      message(SEND_ERROR "There is no ${header}: take it off the list.")
    endif()
    set("place_of_CGAL/${header}" ${place})
  endforeach()
endforeach()
foreach(header IN LISTS headers)
  if(header MATCHES "^CGAL/L0_resampling/internal/([a-z]+)/[^/]*$" AND CMAKE_MATCH_1 IN_LIST order)
    list(FIND order ${CMAKE_MATCH_1} "place_of_${header}")
  elseif(NOT DEFINED "place_of_${header}")
    message(SEND_ERROR "${header} has no place: it belongs in a folder of internal/, or in a list "
                       "of includes_follow_folders.cmake.")
    set("place_of_${header}" -1)
  endif()
endforeach()
foreach(stage IN LISTS stages)
  if(NOT CGAL/L0_resampling/internal/${stage}.h IN_LIST headers)
    message(SEND_ERROR "There is no stage ${stage}: take it off the list.")
  endif()
endforeach()
list(TRANSFORM stages REPLACE "(.+)" "CGAL/L0_resampling/internal/\\1.h")
list(FIND order interface place_of_interface)

foreach(header IN LISTS headers)
  set("included_by_${header}" "")
  set(place ${place_of_${header}})
  file(STRINGS ${INCLUDE_DIRECTORY}/${header} lines REGEX "^[ \t]*#[ \t]*include[ \t]*[<\"]CGAL/")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE "^[^<\"]*[<\"]([^>\"]*).*" "\\1" included "${line}")
    if(NOT included IN_LIST headers)
      if(place LESS place_of_interface AND NOT included IN_LIST kernel_free_headers)
        message(SEND_ERROR "${header} includes ${included}: only the interface sees CGAL's own "
                           "headers.")
      endif()
      continue()
    endif()
    if(place_of_${included} GREATER place)
      list(GET order ${place} folder)
      list(GET order ${place_of_${included}} later)
      message(SEND_ERROR
              "${header} (${folder}) includes ${included} (${later}), which comes later.")
    elseif(header IN_LIST stages AND included IN_LIST stages)
      message(SEND_ERROR "${header} includes ${included}: stages do not include each other.")
    elseif(header MATCHES "/internal/" AND included MATCHES "_solver_traits\\.h$")
      message(SEND_ERROR "${header} includes ${included}: the solver is a template argument.")
    endif()
    list(APPEND "included_by_${header}" ${included})
  endforeach()
endforeach()

# No circles: headers without includes are taken out until none is left.
set(rest ${headers})
while(rest)
  set(taken "")
  foreach(header IN LISTS rest)
    set(is_free TRUE)
    foreach(included IN LISTS "included_by_${header}")
      if(included IN_LIST rest AND NOT included STREQUAL header)
        set(is_free FALSE)
        break()
      endif()
    endforeach()
    if(is_free)
      list(APPEND taken ${header})
    endif()
  endforeach()
  if(NOT taken)
    message(SEND_ERROR "Some of these include each other in a circle: ${rest}")
    break()
  endif()
  list(REMOVE_ITEM rest ${taken})
endwhile()
