# Checks who includes whom:
#   cmake -DINCLUDE_DIRECTORY=<include> [-DSOURCE_DIRECTORY=<all>] -P includes_follow_folders.cmake
#
# The package needs nothing of the tool, the Python package, the benchmarks, the plugins and the
# examples. These include its public headers only and use no name of `internal`: what they need of
# it is documented.
#
# A header includes headers of its own folder and of the folders before it. Stages do not include
# each other: the folders after theirs join them and pass the results of one to the next. Nothing
# under internal/ includes a solver, which is a template argument. Only the interface knows of
# CGAL's kernels and property maps.

cmake_minimum_required(VERSION 3.21)

# Public headers, which have no folder, stand where their contents belong.
set(order license words core kernels plan device search cloud normals samples energy solvers
          orientation driver creases tiles interface calls)
set(license ../license/L0_resampling.h)
set(words value_parameters.h tags.h instructions.h Solver_report.h Quadratic_problem.h Report.h Source_box.h Is_plain.h
          Tile_counts.h)
set(core Attribute_values.h Near_points.h warnings.h)
set(tiles Tile_findings.h Tile_stitching.h Tile_archive.h)
set(solvers Block_chebyshev_solver_traits.h Block_conjugate_gradient_solver_traits.h
            Eigen_cholesky_solver_traits.h Eigen_least_squares_solver_traits.h
            CUDA_least_squares_solver_traits.h)
set(interface Crease.h named_parameters_interface.h named_parameters.h find_near_points.h
              Tile_result.h Tiled_cloud.h)
set(calls CUDA_resampler.h ../l0_resample_point_set.h ../l0_orient_normals.h
          ../l0_estimate_scales.h Tiled_resampling.h ../l0_resample_tiles.h compile_stages.h)

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
set(headers_of_license CGAL/config.h CGAL/license.h)     # and what every license of CGAL includes

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
      if(header STREQUAL "CGAL/license/L0_resampling.h")
        set(allowed ${headers_of_license})
      else()
        set(allowed ${kernel_free_headers})
      endif()
      if(place LESS place_of_interface AND NOT included IN_LIST allowed)
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

# The walls around the package
if(SOURCE_DIRECTORY)
  set(sources_of_package include src/CGAL_L0_CUDA src/CGAL_L0_resampling_compiled)
  set(sources_of_users src/l0_resample src/cgal_l0 src/common benchmark examples plugins demo)
  set(libraries_of_users "^(CLI|nlohmann|pybind11)/|^(png|zlib)\\.h$")

  # The path of an included file of these parts, relative to all, or nothing for other headers
  function(find_included file included result)
    cmake_path(GET file PARENT_PATH folder)
    set(${result} "" PARENT_SCOPE)
    foreach(root IN LISTS sources_of_package sources_of_users ITEMS "${folder}")
      cmake_path(ABSOLUTE_PATH root BASE_DIRECTORY ${SOURCE_DIRECTORY} OUTPUT_VARIABLE root)
      cmake_path(ABSOLUTE_PATH included BASE_DIRECTORY ${root} NORMALIZE OUTPUT_VARIABLE path)
      if(EXISTS ${path})
        cmake_path(RELATIVE_PATH path BASE_DIRECTORY ${SOURCE_DIRECTORY})
        set(${result} ${path} PARENT_SCOPE)
      endif()
    endforeach()
  endfunction()

  foreach(part IN ITEMS package users)
    foreach(folder IN LISTS sources_of_${part})
      file(GLOB_RECURSE files ${SOURCE_DIRECTORY}/${folder}/*.h ${SOURCE_DIRECTORY}/${folder}/*.cpp
           ${SOURCE_DIRECTORY}/${folder}/*.cu ${SOURCE_DIRECTORY}/${folder}/*.cuh)
      if(NOT files)
        message(SEND_ERROR "There are no sources in ${folder}: take it off the list.")
      endif()
      foreach(file IN LISTS files)
        # The Python package has arrays of devices, which no public header has.
        if(part STREQUAL "users" AND NOT folder STREQUAL "src/cgal_l0")
          file(STRINGS ${file} lines REGEX "L0_resampling::internal|[^_a-z]internal::")
          if(lines)
            message(SEND_ERROR "${file} uses a name that is not documented: ${lines}")
          endif()
        endif()
        file(STRINGS ${file} lines REGEX "^[ \t]*#[ \t]*include[ \t]*[<\"]")
        foreach(line IN LISTS lines)
          string(REGEX REPLACE "^[^<\"]*[<\"]([^>\"]*).*" "\\1" included "${line}")
          find_included(${file} ${included} path)
          if(part STREQUAL "package")
            if(included MATCHES "${libraries_of_users}"
               OR (path AND NOT path MATCHES "^(include|src/CGAL_L0_(CUDA|resampling_compiled))/"))
              message(SEND_ERROR "${file} includes ${included}: the package does without.")
            endif()
          elseif(included MATCHES "(^|/)L0_resampling/internal/"
                 OR path MATCHES "^src/CGAL_L0_(CUDA|resampling_compiled)/")
            message(SEND_ERROR "${file} includes ${included}: only public headers are for others.")
          endif()
        endforeach()
      endforeach()
    endforeach()
  endforeach()
endif()
