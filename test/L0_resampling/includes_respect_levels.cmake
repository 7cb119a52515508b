# Checks who includes whom:  cmake -DINCLUDE_DIRECTORY=<include> -P includes_respect_levels.cmake
#
# A header includes only headers listed before its own. Stages (level 2) do not include each other:
# level 3 joins them and passes the results of one to the next. Nothing under internal/ includes a
# solver, which is a template argument. Up to level 3 nothing is known of CGAL's kernels and
# property maps.

cmake_minimum_required(VERSION 3.21)

set(level_0   # words: types, formulas and tools that know nothing of point sets
  tags.h Solver_report.h Quadratic_problem.h
  internal/host_device.h internal/random_bits.h internal/levels_of_scales.h
  internal/exact_ball.h internal/weights.h
  internal/Border_of_ball.h internal/Orientation_hints.h internal/orientation_agreement.h
  internal/side_confidence.h internal/spacing_to_orient.h
  internal/shrinkage.h internal/negligible_displacement.h internal/block_factorization.h
  internal/chebyshev_steps.h internal/matrix_free_product.h
  internal/checked_count.h
  internal/crowded_subcells.h internal/share_of_extent.h
  internal/symmetric_eigen.h internal/Height_moments.h internal/deviation_in_ball.h
  internal/scales_of_balls.h internal/attribute_kinds.h
  internal/Buffer.h internal/lanes.h internal/parallel_for.h internal/parallel_sort.h
  internal/select_nth.h internal/Signed_union_find.h
  internal/Block_counts.h internal/Tiling.h internal/stitch_tiles.h)
set(level_1   # what several stages share, and what works on the arrays of one neighborhood
  Report.h warnings.h internal/Any_solver.h internal/Parameters.h internal/Method_rules.h
  internal/Plane_moments.h
  internal/Morton_points.h internal/scale_field.h internal/Plan.h
  internal/cuda_interface.h internal/cuda_device_arrays.h internal/cuda_orientation.h internal/cuda_answer.h
  internal/Device_progress.h internal/Device_session.h
  internal/Progress.h internal/solver_settings.h internal/Matrix_free_solver.h
  internal/Search_grid_3.h internal/working_frame.h internal/Facts_of_cloud.h
  internal/orientation_votes.h
  internal/dipoles_of_sets.h internal/winding_numbers.h internal/spanning_forest.h internal/Field_of_sets.h
  internal/orientation_field.h internal/ball_queries.h internal/near_pairs.h
  internal/Neighborhoods.h internal/nearest_samples.h
  internal/Point_tree_3.h
  internal/Samples.h internal/Followers.h internal/least_memory.h internal/Local_normals.h
  internal/update_normals.h internal/Quadric_moments.h
  internal/project_to_local_quadric.h internal/estimate_plane.h internal/half_sampling.h
  internal/normal_matrix.h internal/least_squares_rows.h)
set(level_2   # stages and solvers
  internal/extents.h internal/estimate_scales.h internal/estimate_scale_field.h
  internal/find_outliers.h internal/thin_crowds.h
  internal/estimate_pca_normals.h internal/filter_normals.h internal/refit_normals.h
  internal/density_weights.h internal/areas_of_points.h internal/initialize_samples.h
  internal/collapse_fit_term.h internal/Fit_rows.h
  internal/pair_terms.h internal/fit_compatible_points.h internal/refit_sample_normals.h
  internal/tangential_repulsion.h internal/project_to_local_quadrics.h internal/orient_normals.h
  internal/separate_coincident_points.h internal/estimate_feature_confidences.h
  internal/nearest_input_points.h
  Block_chebyshev_solver_traits.h Block_conjugate_gradient_solver_traits.h
  Eigen_cholesky_solver_traits.h
  Eigen_least_squares_solver_traits.h
  CUDA_least_squares_solver_traits.h)
set(level_3   # Algorithm 1, and the whole
  internal/side_hints.h internal/prepare_points.h internal/choose_samples.h
  internal/expected_memory.h
  internal/Minimization_step.h internal/Cpu_points.h internal/Cpu_backend.h internal/run.h internal/resample.h
  internal/Tile_backend.h internal/resample_tile.h
  internal/orient_point_set.h internal/orient_on_device.h)
set(level_4   # what users include, and how it reads what they pass
  named_parameters_interface.h named_parameters.h internal/checked_parameters.h
  internal/output_iterators.h internal/checked_types.h
  internal/points_of_range.h internal/compiled_templates.h internal/Point_data.h
  internal/resample_on_cpu.h
  internal/carry_properties.h CUDA_resampler.h
  ../l0_resample_point_set.h ../l0_orient_normals.h
  Tiled_resampling.h ../l0_resample_tiles.h)

set(kernel_free_headers CGAL/tags.h CGAL/assertions.h)   # all that levels 0 to 3 may have of CGAL

set(order "")
foreach(level RANGE 4)
  foreach(header IN LISTS level_${level})
    string(REGEX REPLACE "^L0_resampling/../" "" header "L0_resampling/${header}")
    list(APPEND order "CGAL/${header}")
    set("level_of_CGAL/${header}" ${level})
  endforeach()
endforeach()

file(GLOB_RECURSE headers RELATIVE ${INCLUDE_DIRECTORY} ${INCLUDE_DIRECTORY}/*.h)
if(NOT headers)
  message(FATAL_ERROR "There are no headers in '${INCLUDE_DIRECTORY}'.")
endif()
foreach(header IN LISTS order)
  if(NOT header IN_LIST headers)
    message(SEND_ERROR "There is no ${header}: take it off the list.")
  endif()
endforeach()
foreach(header IN LISTS headers)
  list(FIND order ${header} place)
  if(place EQUAL -1)
    message(SEND_ERROR "${header} has no level yet: list it in includes_respect_levels.cmake.")
    continue()
  endif()
  set(level ${level_of_${header}})

  file(STRINGS ${INCLUDE_DIRECTORY}/${header} lines REGEX "^[ \t]*#[ \t]*include[ \t]*[<\"]CGAL/")
  foreach(line IN LISTS lines)
    string(REGEX REPLACE "^[^<\"]*[<\"]([^>\"]*).*" "\\1" included "${line}")
    list(FIND order ${included} included_place)
    if(included_place EQUAL -1)
      if(level LESS 4 AND NOT included IN_LIST kernel_free_headers)
        message(SEND_ERROR "${header} (level ${level}) includes ${included}: "
                           "only level 4 sees CGAL's own headers.")
      endif()
    elseif(NOT included_place LESS place)
      message(SEND_ERROR
              "${header} (level ${level}) includes ${included} (level ${level_of_${included}}), "
              "which is not below it.")
    elseif(level EQUAL 2 AND level_of_${included} EQUAL 2)
      message(SEND_ERROR "${header} includes ${included}: stages do not include each other.")
    elseif(header MATCHES "/internal/" AND included MATCHES "_solver_traits\\.h$")
      message(SEND_ERROR "${header} includes ${included}: the solver is a template argument.")
    endif()
  endforeach()
endforeach()
