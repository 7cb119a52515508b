// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// Prints the defaults of the named parameters and the constants of the methods as JSON, for
// generate_text.py and check_manual.py. With two numbers, spacing and noise, it prints the radius
// that the default method takes.

#include <CGAL/L0_resampling/internal/core/Orientation_hints.h>
#include <CGAL/L0_resampling/internal/creases/crease_points.h>
#include <CGAL/L0_resampling/internal/interface/checked_parameters.h>
#include <CGAL/L0_resampling/internal/kernels/Border_of_ball.h>
#include <CGAL/L0_resampling/internal/kernels/crowded_subcells.h>
#include <CGAL/L0_resampling/internal/kernels/deviation_of_sample.h>
#include <CGAL/L0_resampling/internal/kernels/lengths_of_refinement.h>
#include <CGAL/L0_resampling/internal/kernels/merged_disk.h>
#include <CGAL/L0_resampling/internal/kernels/orientation_agreement.h>
#include <CGAL/L0_resampling/internal/kernels/scale_field.h>
#include <CGAL/L0_resampling/internal/kernels/scales_of_balls.h>
#include <CGAL/L0_resampling/internal/search/ball_queries.h>

#include <cstdlib>
#include <iostream>
#include <sstream>
#include <string>

using namespace CGAL::L0_resampling;
using namespace CGAL::L0_resampling::internal;

namespace {

/// `"name": value`, with a comma before all but the first of an object.
class Object
{
  const char* m_separator = "";

public:
  template <typename T>
  void add(const char* name, const T& value)
  {
    std::cout << m_separator << "\n    \"" << name << "\": " << value;
    m_separator = ",";
  }
};

void print_defaults(const char* name, Method method)
{
  const std::size_t n = 1000; // enough to read a percentage off the number of points
  const Parameters p = checked_parameters(CGAL::parameters::resampling_method(method), n);
  std::cout << "  \"" << name << "\": {";
  Object object;
  object.add("select_percentage", double(p.number_of_output_points) * 100 / double(n));
  object.add("sharpness_angle", p.sharpness_angle);
  object.add("number_of_normal_filter_iterations", p.number_of_normal_filter_iterations);
  object.add("normal_weight", p.normal_weight);
  object.add("regularization_weight", p.regularization_weight);
  object.add("initial_penalty", p.initial_penalty);
  object.add("maximum_penalty", p.maximum_penalty);
  object.add("penalty_growth", p.penalty_growth);
  object.add("number_of_orientation_neighbors", p.number_of_orientation_neighbors);
  object.add("random_seed", p.random_seed);
  std::cout << "\n  },\n";
}

/// Of all scales, as a list.
std::string radii_of_fits()
{
  std::ostringstream list;
  for (int scale = 0; scale < number_of_fit_scales; ++scale)
    list << (scale > 0 ? ", " : "[") << radius_of_fit(scale);
  list << "]";
  return list.str();
}

void print_constants()
{
  const Repulsion repulsion(
    1, 1e3); // in units of the spacing, of a radius that does not limit the step
  std::cout << "  \"constant\": {";
  Object object;
  object.add("self_neighbor_radius_factor", self_neighbor_radius_factor);
  object.add("inner_radius_factor", inner_radius_factor);
  object.add("unexplained_radius_factor", unexplained_radius_factor);
  object.add("minimum_number_of_points_of_plane", minimum_number_of_points_of_plane);
  object.add("spatial_bandwidth_factor", spatial_bandwidth_factor);
  object.add("sparsity_unit_factor", sparsity_unit_factor);
  object.add("radius_per_spacing", radius_per_spacing);
  object.add("radius_per_noise", radius_per_noise);
  object.add("radius_of_balls_per_noise", radius_of_balls_per_noise);
  object.add("minimum_count_of_balls", minimum_count_of_balls);
  object.add("ratio_of_larger_balls", ratio_of_larger_balls);
  object.add("maximum_share_of_growth", maximum_share_of_growth);
  object.add("fit_angle_factor", fit_angle_factor);
  object.add("fit_bandwidth_factor", fit_bandwidth_factor);
  object.add("sheet_height_per_noise", sheet_height_per_noise);
  object.add("sheet_height_per_radius", sheet_height_per_radius);
  object.add("minimum_height_between_sheets", minimum_height_between_sheets);
  object.add("outlier_share_of_surroundings", outlier_share_of_surroundings);
  object.add("outlier_share_of_median", outlier_share_of_median);
  object.add("share_of_sparse_points", share_of_sparse_points);
  object.add("sheet_share_of_surroundings", sheet_share_of_surroundings);
  object.add("maximum_number_of_points_of_subcell", maximum_number_of_points_of_subcell);
  object.add("volume_filling_ratio", volume_filling_ratio);
  object.add("radii_of_sparse_sheet", radii_of_sparse_sheet);
  object.add("points_of_seed", points_of_seed);
  object.add("seeds_of_group", seeds_of_group);
  object.add("indifferent_scale", indifferent_scale);
  object.add("slope_of_scales", slope_of_scales);
  object.add("number_of_normal_refits", number_of_normal_refits);
  object.add("self_neighbor_radius_per_spacing", self_neighbor_radius_per_spacing);
  object.add("share_of_unsupported", share_of_unsupported);
  object.add("held_back_from", held_back_from);
  object.add("held_back_to", held_back_to);
  object.add("minimum_gap_of_plane", minimum_gap_of_plane);
  object.add("quadric_radius_factor", quadric_radius_factor);
  object.add("maximum_roughness", maximum_roughness);
  object.add("maximum_leverage", maximum_leverage);
  object.add("minimum_support_points_in_ball", minimum_support_points_in_ball);
  object.add("number_of_repulsion_steps", number_of_repulsion_steps);
  object.add("repulsion_squared_bandwidth", repulsion.squared_bandwidth);
  object.add("repulsion_strength", repulsion.strength);
  object.add("repulsion_maximum_step", repulsion.maximum_step);
  object.add("number_of_refinements", number_of_refinements);
  object.add("unit_per_point_spacing", unit_per_point_spacing);
  object.add("extent_of_disk", extent_of_disk);
  object.add("reach_of_disk", reach_of_disk);
  object.add("share_of_outliers", share_of_outliers);
  object.add("minimum_noise_per_unit", minimum_noise_per_unit);
  object.add("number_of_fit_scales", number_of_fit_scales);
  object.add("opening_of_face", opening_of_face);
  object.add("residual_per_deviation", residual_per_deviation);
  object.add("residual_per_radius", residual_per_radius);
  object.add("minimum_deviation_of_disk", minimum_deviation_of_disk);
  object.add("cell_of_merged_disks", cell_of_merged_disks);
  object.add("minimum_cosine_of_merged", minimum_cosine_of_merged);
  object.add("maximum_height_of_merged", maximum_height_of_merged);
  object.add("number_of_clearances", number_of_clearances);
  object.add("deviation_per_deviation_of_fit", deviation_per_deviation_of_fit);
  object.add("extent_of_normals", extent_of_normals);
  object.add("clearance_per_spacing", clearance_per_spacing);
  object.add("reach_of_clearance", reach_of_clearance);
  object.add("maximum_cosine_across_crease", maximum_cosine_across_crease);
  object.add("cosine_of_other_face", cosine_of_other_face);
  object.add("minimum_weight_of_face", minimum_weight_of_face);
  object.add("radius_of_fit", radii_of_fits());
  object.add("reach_of_crease", reach_of_crease);
  object.add("radius_of_face", radius_of_face);
  object.add("height_deviation_of_face", height_deviation_of_face);
  object.add("normal_deviation_of_face", normal_deviation_of_face);
  object.add("curvature_of_faces", curvature_of_faces);
  object.add("beyond_doubt", beyond_doubt);
  object.add("clear_majority", clear_majority);
  object.add("minimum_certain_cosine", minimum_certain_cosine);
  object.add("maximum_number_of_candidates", maximum_number_of_candidates);
  std::cout << "\n  }\n";
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc == 3)
  {
    std::cout.precision(17);
    std::cout << default_radius(std::atof(argv[1]), std::atof(argv[2])) << "\n";
    return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
  }
  std::cout << "{\n";
  print_defaults("default", Method::DEFAULT);
  print_defaults("lor", Method::LOR);
  print_defaults("alor", Method::ALOR);
  print_constants();
  std::cout << "}\n";
  return std::cout.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
}
