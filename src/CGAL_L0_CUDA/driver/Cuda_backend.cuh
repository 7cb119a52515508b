// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_CUDA_CUDA_BACKEND_CUH
#define CGAL_L0_CUDA_CUDA_BACKEND_CUH

#include "driver/Cuda_points.cuh"
#include "samples/Refinement.cuh"

#include <CGAL/L0_resampling/internal/plan/Plan.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace CGAL {
namespace L0_resampling {
namespace internal {
namespace cuda {

/// What the filter of normals works on, in the scratch arena.
struct Filter_arrays
{
  Arena_scope scope;
  float4 *normals, *filtered; // that are read next, and written next
  Device_counter<Ball_counts> ball_counts;
  Cell_blocks blocks; // of the radius of the filter

  Filter_arrays(const Execution_context& context, float4* result, unsigned size)
    : scope(context.scratch), normals(result), filtered(context.scratch.take<float4>(size)),
      ball_counts(context)
  {}
};

/// The samples in the order of their grid, of which only the points are needed any further, and
/// their self neighbors, in the arena.
struct Neighborhood
{
  Arena_scope scope;
  Cell_grid points;
  Neighbor_lists neighbors;
  int4* places = nullptr; // as the points, for the neighbors that repel each other; if any do
  Neighbor_lists spreading;

  explicit Neighborhood(Device_arena& arena) : scope(arena) {}
};

/// The stages on the device, and the arrays of one call. What calls them, and in which order,
/// stands in `run.h`; what they do, in `stages.cuh` and as on the CPU. The result is left in the
/// session.
class Cuda_backend : public Cuda_points
{
protected: // for backends that differ in a stage
  Samples m_samples;
  Cell_grid m_grid;                         // of the points
  Areas m_areas;                            // of the points, for the first samples
  std::optional<Arena_scope> m_areas_scope; // of the arena
  float4* m_normals = nullptr;              // of the points, filtered, and 1/v_j
  std::optional<Filter_arrays> m_filter;
  const unsigned* m_numbers_of_points = nullptr; // that each one stands for; null if only itself

private:
  const unsigned m_number_of_samples; // of the result
  std::vector<Turn> m_turns;
  std::vector<Turn_result> m_results;          // of these, on the host
  Turn_result* m_turn_results = nullptr;       // the same, on the device
  Sample_counts* m_counts = nullptr;           // on the device
  std::vector<std::size_t> m_numbers_of_pairs; // of self neighbors, in each turn
  unsigned m_number_of_leaders = 0;            // the samples, without those that follow others
  Duplicate_samples m_followers;

  std::optional<Arena_scope> m_points_scope; // of the arena
  std::optional<Arena_scope> m_order_scope;  // of the scratch arena: the order of the points before

  std::optional<Neighborhood> m_neighborhood;
  std::optional<Arena_scope> m_sample_grid_scope; // of the scratch arena
  Cell_grid m_sample_grid;                        // that neighbors are found in

  std::optional<Arena_scope> m_refined_scope; // of the arena: the samples while they are refined
  Samples m_samples_before;                   // where they go afterwards
  std::optional<Refinement> m_refinement;     // of a round

public:
  // Without them, the device need not wait; the host finds them of the result.
  static constexpr bool finds_feature_confidences = false, foresees_memory = false;
  static constexpr bool may_need_explicit_rows = false;

  /// \param number_of_samples of the result
  Cuda_backend(Session& session, const Parameters& parameters, unsigned number_of_samples,
               Stages& stages, Call_report& report)
    : Cuda_points(session, parameters, stages, report), m_number_of_samples(number_of_samples)
  {}

  void end_turn(std::size_t number, std::size_t number_of_turns)
  {
    m_stages.ask(double(number + 1) / double(number_of_turns));
  }

  std::size_t number_of_samples() const { return m_samples.size; }

  void begin(const Plan& plan);

  // The points
  void drop_outliers(const Plan& plan);
  void sort_points(const Plan& plan);
  bool are_all_normals_given() const { return m_input.all_normals_given; }
  void estimate_pca_normals(const Plan& plan) { estimate_pca_normals(plan, m_numbers_of_points); }
  void take_given_normals();
  void refit_normals(const Plan& plan);
  void filter_normals(const Plan& plan, std::size_t pass);
  void weigh_density(const Plan& plan) { weigh_density(plan, 0); }

  // The first samples
  double total_area(const Plan& plan);
  void choose_samples(const Plan& plan) { choose_samples(plan, nullptr); }

  // Algorithm 1
  void collapse_fit_term(const Plan& plan);
  void release_points() { m_points_scope.reset(); }
  void sort_samples(const Plan& plan);
  void find_self_neighbors(const Plan& plan);
  void minimize_once(const Plan& plan, const Turn& turn);
  void release_neighbors() { m_neighborhood.reset(); }

  // Algorithm 1 of the default method
  void fit_compatible_points(const Plan& plan, bool is_last);
  void repel_tangentially(const Plan& plan,
                          std::size_t number_of_steps = number_of_repulsion_steps);
  void take_fitted_positions() { cuda::take_fitted_positions(m_context, m_samples); }

  // The end
  void orient_normals(const Plan& plan);
  void project_to_local_quadrics(const Plan& plan);

  // The refinement
  void begin_deviations(const Plan& plan);
  void begin_refinement();
  void spread_samples(const Plan& plan);
  void split_sheets(const Plan& plan);
  void share_points(const Plan& plan);
  void fit_disks(int scale) { m_refinement->fit_disks(scale); }
  void weigh_by_risk(int scale) { m_refinement->weigh_by_risk(scale); }
  void take_mean_surfaces() { m_refinement->take_mean_surfaces(); }
  void keep_clear_of_creases() { m_refinement->keep_clear_of_creases(); }
  void find_deviations() { m_refinement->find_deviations(); }
  void end_refinement();

  void append_followers();
  void measure_extent(const Plan& plan);
  void leave_frame() { cuda::leave_frame(m_context, m_box.frame, m_samples); }
  void end(const Plan& plan);

protected:
  /// \param numbers_of_points as how many each point is reported; null for one each
  void estimate_pca_normals(const Plan& plan, const unsigned* numbers_of_points);
  /// \param known_mean number of neighbors; 0 if it is to be found
  void weigh_density(const Plan& plan, double known_mean);
  /// \param known null if the samples are to be chosen
  void choose_samples(const Plan& plan, const Known_starts* known);

private:
  void list_outliers(const unsigned* kept, unsigned number_of_outliers);
  void report_unexplained_place(const Plan& plan, const unsigned char* are_unexplained);
  void begin_round(const Plan& plan);
  void take_vectors_of_list();
  void build_grid_of_points(const Plan& plan);
  Cell_blocks blocks_of_points(const Plan& plan, double radius) const;
  Positions sample_positions(const float* scales) const;
  bool spreads_wider(const Plan& plan) const { return plan.refines && m_samples.scales; }
  double maximum_range(const Plan& plan) const;
  bool is_one_grid_enough(const Plan& plan) const;
  Cell_frame self_frame(const Plan& plan, double cell_size) const;
};

} // namespace cuda
} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_CUDA_CUDA_BACKEND_CUH
