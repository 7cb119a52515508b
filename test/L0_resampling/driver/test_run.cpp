// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The driver, on a backend that does nothing but write down what it is asked for.

#include "test_support.h"

#include <CGAL/L0_resampling/Report.h>
#include <CGAL/L0_resampling/internal/driver/run.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace {

using namespace CGAL::L0_resampling;
using namespace CGAL::L0_resampling::internal;

/// One unit of its frame is two of the input.
struct Recording_frame
{
  double unit = 2;

  double length_of_input(double length) const { return unit * length; }
};

class Recorder
{
  Recording_frame m_frame;
  Report m_report;

  void note(const std::string& name) { names.push_back(name); }
  void note(const std::string& name, const Plan& plan)
  {
    note(name);
    spacing = plan.sample_spacing;
    low_end_of_spectrum = plan.minimization.low_end_of_spectrum({0, 1, true});
  }

public:
  static constexpr bool finds_feature_confidences = true, may_need_explicit_rows = true,
                        foresees_memory = true;

  // What a test may set
  bool all_normals_given = false, needs_rows = false;
  // What it may look at
  std::vector<std::string> names; // of the members, and in brackets those of the stages
  double spacing = 0;             // of the samples in the last plan
  double low_end_of_spectrum = 0; // for a penalty of 1, in the last plan
  std::vector<Turn> turns;

  std::size_t count(const std::string& name) const
  {
    return std::size_t(std::count(names.begin(), names.end(), name));
  }

  /// The place of the only call, or of the last one.
  std::size_t place(const std::string& name) const
  {
    const auto found = std::find(names.rbegin(), names.rend(), name);
    CHECK(found != names.rend());
    return std::size_t(names.rend() - found);
  }

  void begin_stage(const std::string& name, double, std::size_t) { note("[" + name + "]"); }
  void end_turn(std::size_t number, std::size_t number_of_turns)
  {
    CHECK(number < number_of_turns);
  }
  Report& report() { return m_report; }
  const Recording_frame& frame() const { return m_frame; }
  std::size_t number_of_points() const { return 1000; }
  std::size_t number_of_samples() const { return 500; }

  Facts find_facts()
  {
    note("find_facts");
    return {1000, 20, 10, 0};
  }
  Scales estimate_scales(double paper_radius)
  {
    note("estimate_scales");
    CHECK(paper_radius == 1);
    return {0.2, 0.01};
  }
  Range_of_scales estimate_scale_field(double, const Reference_scales& usual)
  {
    note("estimate_scale_field");
    CHECK(usual.spacing == 0.2);
    return {0.5, 1, 2};
  }
  void set_unit(double unit)
  {
    note("set_unit");
    m_frame.unit *= unit;
  }
  void begin(const Plan& plan) { note("begin", plan); }
  void drop_outliers(const Plan& plan) { note("drop_outliers", plan); }
  void sort_points(const Plan& plan) { note("sort_points", plan); }
  void refuse_too_little_memory(const Plan& plan) { note("refuse_too_little_memory", plan); }
  bool are_all_normals_given() const { return all_normals_given; }
  void estimate_pca_normals(const Plan& plan) { note("estimate_pca_normals", plan); }
  void take_given_normals() { note("take_given_normals"); }
  void refit_normals(const Plan& plan) { note("refit_normals", plan); }
  void filter_normals(const Plan& plan, std::size_t) { note("filter_normals", plan); }
  void weigh_density(const Plan& plan) { note("weigh_density", plan); }
  double total_area(const Plan& plan)
  {
    note("total_area", plan);
    return 125;
  }
  void choose_samples(const Plan& plan) { note("choose_samples", plan); }
  void collapse_fit_term(const Plan& plan) { note("collapse_fit_term", plan); }
  bool needs_explicit_rows() const { return needs_rows; }
  void gather_fit_rows(const Plan& plan) { note("gather_fit_rows", plan); }
  void release_points() { note("release_points"); }
  void sort_samples(const Plan& plan) { note("sort_samples", plan); }
  void find_self_neighbors(const Plan& plan) { note("find_self_neighbors", plan); }
  void minimize_once(const Plan& plan, const Turn& turn)
  {
    note("minimize_once", plan);
    turns.push_back(turn);
  }
  void release_neighbors() { note("release_neighbors"); }
  void fit_compatible_points(const Plan& plan, bool is_last)
  {
    note(is_last ? "last fit" : "fit", plan);
  }
  void repel_tangentially(const Plan& plan) { note("repel_tangentially", plan); }
  void take_fitted_positions() { note("take_fitted_positions"); }
  void orient_normals(const Plan& plan) { note("orient_normals", plan); }
  void project_to_local_quadrics(const Plan& plan) { note("project_to_local_quadrics", plan); }
  void begin_refinement() { note("begin_refinement"); }
  void spread_samples(const Plan& plan) { note("spread_samples", plan); }
  void split_sheets(const Plan& plan) { note("split_sheets", plan); }
  void share_points(const Plan& plan) { note("share_points", plan); }
  void fit_disks(int scale) { note("fit_disks " + std::to_string(scale)); }
  void weigh_by_risk(int scale) { note("weigh_by_risk " + std::to_string(scale)); }
  void take_mean_surfaces() { note("take_mean_surfaces"); }
  void keep_clear_of_creases() { note("keep_clear_of_creases"); }
  void end_refinement() { note("end_refinement"); }
  void estimate_feature_confidences(const Plan& plan) { note("confidences", plan); }
  void begin_deviations(const Plan& plan) { note("begin_deviations", plan); }
  void find_deviations() { note("find_deviations"); }
  void append_followers() { note("append_followers"); }
  void measure_extent(const Plan& plan) { note("measure_extent", plan); }
  void leave_frame() { note("leave_frame"); }
  void end(const Plan& plan) { note("end", plan); }
};

Parameters parameters_of(Method method)
{
  Parameters parameters;
  parameters.method = method;
  parameters.number_of_output_points = 500;
  parameters.penalty_growth = rules_of(method).penalty_growth;
  return parameters;
}

Recorder recorded(const Parameters& parameters, Recorder backend = {})
{
  run(plan_call(parameters, backend), backend);
  return backend;
}

const Method methods[] = {Method::LOR, Method::ALOR, Method::DEFAULT};

/// What looks at an array comes before the array is given back, and that is once.
void test_arrays()
{
  for (const Method method : methods)
  {
    const Recorder r = recorded(parameters_of(method));
    CHECK(r.count("release_points") == 1 && r.count("release_neighbors") == 1);
    const bool refines = method == Method::DEFAULT;
    CHECK(r.place("release_points") > r.place(refines ? "share_points" : "collapse_fit_term"));
    CHECK(r.place("release_neighbors") > r.place(refines ? "repel_tangentially" : "minimize_once"));
    // where points are not needed, they do not stand beside the lists of neighbors
    CHECK(refines == (r.place("release_points") > r.place("find_self_neighbors")));
    CHECK(r.names.back() == "end" && r.place("leave_frame") > r.place("measure_extent"));
    CHECK(r.place("measure_extent") > r.place("append_followers"));
  }
}

void test_turns()
{
  for (const Method method : methods)
  {
    const Recorder r = recorded(parameters_of(method));
    const bool refines = method == Method::DEFAULT;
    const std::size_t number = r.turns.size();
    CHECK(number == (refines ? 4 : 8));
    for (const Turn& turn : r.turns)
    {
      const std::size_t i = std::size_t(&turn - r.turns.data());
      CHECK(turn.number == i && turn.regularizes == (method != Method::ALOR || i % 2 == 0));
      CHECK(std::abs(turn.penalty - 0.1 * std::pow(refines ? 2.7 : 1.5, double(i))) < 1e-12);
    }
    for (const char* const name : {"sort_samples", "find_self_neighbors"})
      CHECK(r.count(name) == (refines ? number : 1));
    for (const char* const name : {"fit", "repel_tangentially"})
      CHECK(r.count(name) == (refines ? number : 0));
    CHECK(r.count("project_to_local_quadrics") == refines);
    if (refines)
      CHECK(r.place("take_fitted_positions") == r.place("last fit") + 1);
  }
}

/// The refinement, of which each round ends with what the next one starts with: only the default
/// method has it, once the sides are known.
void test_refinement()
{
  const std::vector<std::string> of_round = {
    "spread_samples",     "share_points",          "fit_disks 0",          "weigh_by_risk 0",
    "fit_disks 1",        "weigh_by_risk 1",       "fit_disks 2",          "weigh_by_risk 2",
    "fit_disks 3",        "weigh_by_risk 3",       "fit_disks 4",          "weigh_by_risk 4",
    "take_mean_surfaces", "keep_clear_of_creases", "keep_clear_of_creases"};
  std::vector<std::string> expected = {"[project to local quadrics]",
                                       "project_to_local_quadrics",
                                       "[refine samples]",
                                       "begin_refinement",
                                       "spread_samples",
                                       "split_sheets"};
  for (int round = 0; round < 2; ++round)
    expected.insert(expected.end(), of_round.begin(), of_round.end());
  expected.insert(expected.end(), {"end_refinement", "release_points"});

  const Recorder r = recorded(parameters_of(Method::DEFAULT));
  const auto begin = std::find(r.names.begin(), r.names.end(), expected.front());
  CHECK(std::size_t(r.names.end() - begin) > expected.size()
        && std::equal(expected.begin(), expected.end(), begin));
  CHECK(r.place("orient_normals") < r.place("[refine samples]"));
  for (const Method method : {Method::LOR, Method::ALOR})
    CHECK(recorded(parameters_of(method)).count("[refine samples]") == 0);
}

void test_normals()
{
  for (const Method method : methods)
    for (const std::size_t number_of_passes : {0, 1, 5})
    {
      Parameters parameters = parameters_of(method);
      parameters.number_of_normal_filter_iterations = number_of_passes;
      const Recorder r = recorded(parameters);
      CHECK(r.count("filter_normals") == number_of_passes);
      const std::size_t number_of_refits = method == Method::DEFAULT
                                             ? (std::min)(number_of_passes, std::size_t(2))
                                             : 0;
      CHECK(r.count("refit_normals") == number_of_refits);
      if (number_of_refits > 0) // a pass of the filter follows each
        CHECK(r.place("filter_normals") == r.place("refit_normals") + 1);
      CHECK(r.place("take_given_normals") > r.place("estimate_pca_normals"));
    }
  Recorder given;
  given.all_normals_given = true;
  const Recorder r = recorded(parameters_of(Method::DEFAULT), given);
  CHECK(r.count("estimate_pca_normals") == 0 && r.count("[PCA normals]") == 0);
}

void test_switches()
{
  for (const Method method : methods)
  {
    const Recorder without = recorded(parameters_of(method));
    Parameters parameters = parameters_of(method);
    parameters.outlier_sensitivity = 1;
    parameters.with_feature_confidences = true;
    parameters.with_deviations = true;
    Recorder solver_with_rows;
    solver_with_rows.needs_rows = true;
    const Recorder with = recorded(parameters, solver_with_rows);
    for (const char* const name : {"drop_outliers", "confidences"})
      CHECK(without.count(name) == 0 && with.count(name) == 1);
    CHECK(without.count("begin_deviations") == 0);
    CHECK(with.count("begin_deviations") == (method == Method::DEFAULT));
    CHECK(without.count("gather_fit_rows") == 0);
    CHECK(with.count("gather_fit_rows") == (method != Method::DEFAULT));
    CHECK(with.place("drop_outliers") < with.place("sort_points"));
    // before the work that is worth sparing
    CHECK(with.place("refuse_too_little_memory") == with.place("sort_points") + 1);
    CHECK(with.count("[sort points]") == 2);
  }
}

/// What is found of the cloud is what the plan is made of, and on the way the area.
void test_facts()
{
  Recorder lor = recorded(parameters_of(Method::LOR));
  CHECK(lor.count("estimate_scales") + lor.count("estimate_scale_field") == 0);
  CHECK(lor.report().neighbor_radius == 2 && lor.report().largest_neighbor_radius == 2);
  CHECK(lor.count("total_area") == 0 && std::abs(lor.spacing - 10 / std::sqrt(500)) < 1e-12);

  Recorder r = recorded(parameters_of(Method::DEFAULT));
  const double radius = default_radius(0.2, 0.01);
  CHECK(std::abs(r.report().neighbor_radius - 2 * radius) < 1e-12);
  CHECK(std::abs(r.report().largest_neighbor_radius - 4 * radius) < 1e-12);
  CHECK(r.place("total_area") < r.place("choose_samples"));
  CHECK(r.report().sample_spacing > 0 && lor.report().sample_spacing == 0);
  CHECK(r.spacing == 0.5); // 125 for 500
  // where scales differ, few points may hold many samples: the solver gets more to do
  CHECK(lor.low_end_of_spectrum == low_end_of_spectrum(0.15, 1, 1));
  CHECK(r.low_end_of_spectrum == low_end_of_spectrum(0.15, 1, coupling_of_radii(4)));
  CHECK(coupling_of_radii(1) == 1 && coupling_of_radii(1.01) < 1.1);
  CHECK(coupling_of_radii(2) > 3 && coupling_of_radii(1e9) < 100);

  Parameters parameters = parameters_of(Method::DEFAULT);
  parameters.neighbor_radius = 3;
  Recorder given = recorded(parameters);
  CHECK(given.count("estimate_scales") == 1 && given.count("estimate_scale_field") == 1);
  CHECK(given.report().neighbor_radius == 6 && given.report().largest_neighbor_radius == 12);
  CHECK(given.low_end_of_spectrum == r.low_end_of_spectrum);
}

} // namespace

int main()
{
  test_arrays();
  test_turns();
  test_refinement();
  test_normals();
  test_switches();
  test_facts();
  return test::result();
}
