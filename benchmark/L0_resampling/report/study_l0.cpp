// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// LOR with its energy changed as the paper's Fig. 2, 4 and 5 have it. A solver that is given the
// rows of Eq. (11) changes them before it solves, so that nothing of the package has to know.

#include "../methods/method_program.h"

#include <CGAL/L0_resampling/Eigen_least_squares_solver_traits.h>
#include <CGAL/l0_resample_point_set.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace L0_benchmark;
namespace l0 = CGAL::L0_resampling;

struct Change
{
  int equation = 6;              // 3: no regularization, no density weights; 4: no density weights
  std::string neighbors = "all"; // the original neighbors that are left: see the option
  bool interleave = false;       // Section 4.2
  double regularization_weight = 0.15; // alpha
};

/// Replaces pairs of points by their means, as Algorithm 2 has it: those at the least distances
/// first, of equal ones that of the lower index.
/// \param weights of the points, by which they are averaged; those of a pair add up
void merge_pairs(std::vector<Eigen::Vector3d>& positions, std::vector<double>& weights)
{
  struct Pair
  {
    double squared_distance;
    std::size_t i, j;
  };
  const std::size_t size = positions.size();
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < size; ++i)
    for (std::size_t j = i + 1; j < size; ++j)
      pairs.push_back({(positions[i] - positions[j]).squaredNorm(), i, j});
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) {
    return a.squared_distance < b.squared_distance;
  });
  std::vector<std::size_t> partners(size, size);
  for (const Pair& pair : pairs)
    if (partners[pair.i] == size && partners[pair.j] == size) {
      partners[pair.i] = pair.j;
      partners[pair.j] = pair.i;
    }
  std::vector<Eigen::Vector3d> merged_positions;
  std::vector<double> merged_weights;
  for (std::size_t i = 0; i < size; ++i) {
    const std::size_t j = partners[i] == size ? i : partners[i];
    if (j < i)
      continue;
    const double weight = i == j ? weights[i] : weights[i] + weights[j];
    merged_positions.push_back(
      i == j ? positions[i] : (weights[i] * positions[i] + weights[j] * positions[j]) / weight);
    merged_weights.push_back(weight);
  }
  positions = std::move(merged_positions);
  weights = std::move(merged_weights);
}

/// The fit rows as they are to be.
struct Fit_rows
{
  std::vector<std::size_t> offsets;
  std::vector<double> positions, weights;
};

class Changing_solver_traits
{
  const Change& m_change;
  Fit_rows m_rows; // those of the first solve: the neighbors stay
  Json m_densities = Json::array();
  std::size_t m_number_of_solves = 0;
  l0::Eigen_least_squares_solver_traits<double> m_solver;

public:
  using FT = double;
  static constexpr bool needs_explicit_rows = true;

  explicit Changing_solver_traits(const Change& change) : m_change(change) {}

  /// After each solve, w_i of Eq. (5) at the samples that are a tenth, five tenths and nine tenths
  /// through the list.
  const Json& densities() const { return m_densities; }

  l0::Solver_report solve(const l0::Quadratic_problem<double>& problem,
                          Eigen::Ref<Eigen::VectorXd> x)
  {
    if (m_number_of_solves == 0)
      m_rows = changed_rows(problem);
    l0::Explicit_rows<double> rows = *problem.rows;
    rows.fit_offsets = m_rows.offsets.data();
    rows.fit_positions = m_rows.positions.data();
    rows.fit_weights = m_rows.weights.data();
    const std::vector<double> pair_weights = changed_pair_weights(problem);
    const l0::Quadratic_problem<double> changed{
      problem.fit_weights,           problem.self_neighbors,
      problem.sample_normals,        {pair_weights.data(), Eigen::Index(pair_weights.size())},
      problem.right_hand_side,       problem.penalty,
      problem.normal_spreads,        &rows,
      problem.right_hand_side_scale, problem.memory};
    const l0::Solver_report solved = m_solver.solve(changed, x);
    record_densities(problem, x);
    ++m_number_of_solves;
    return solved;
  }

private:
  static constexpr double radius = 1; // r_p, which is the unit of the rows

  /// \f$ \sigma_q^2 \f$ of Eq. (5), of which the paper only says that it scales with the radius.
  static constexpr double squared_bandwidth = 0.25 * radius * radius;

  Fit_rows changed_rows(const l0::Quadratic_problem<double>& problem) const
  {
    const l0::Explicit_rows<double>& rows = *problem.rows;
    std::mt19937_64 random(1);
    Fit_rows changed;
    changed.offsets.push_back(0);
    for (std::size_t i = 0; i < problem.number_of_samples(); ++i) {
      const Eigen::Map<const Eigen::Vector3d> origin(rows.origins + 3 * i);
      std::vector<Eigen::Vector3d> positions;
      std::vector<double> weights;
      for (std::size_t j = rows.fit_offsets[i]; j < rows.fit_offsets[i + 1]; ++j) {
        positions.push_back(Eigen::Map<const Eigen::Vector3d>(rows.fit_positions + 3 * j));
        weights.push_back(m_change.equation == 6 ? rows.fit_weights[j] : 1);
      }
      std::size_t size = positions.size();
      if (m_change.neighbors == "smaller-radius")
        size = keep_if(positions, weights, [&](const Eigen::Vector3d& q) {
          return (q - origin).norm() < 0.75 * radius;
        });
      else if (m_change.neighbors == "random-half")
        size = keep_if(positions, weights,
                       [&](const Eigen::Vector3d&) { return (random() & 1) == 0; });
      else if (m_change.neighbors == "merged-pairs") {
        merge_pairs(positions, weights);
        size = positions.size();
      }
      for (std::size_t j = 0; j < size; ++j) {
        changed.positions.insert(changed.positions.end(), positions[j].data(),
                                 positions[j].data() + 3);
        changed.weights.push_back(weights[j]);
      }
      changed.offsets.push_back(changed.weights.size());
    }
    return changed;
  }

  /// Moves what is kept to the front, the first one if none is. \returns the number kept
  template <typename Predicate>
  static std::size_t keep_if(std::vector<Eigen::Vector3d>& positions, std::vector<double>& weights,
                             const Predicate& is_kept)
  {
    std::size_t size = 0;
    for (std::size_t j = 0; j < positions.size(); ++j)
      if (is_kept(positions[j])) {
        positions[size] = positions[j];
        weights[size++] = weights[j];
      }
    return (std::max)(size, std::size_t(1));
  }

  std::vector<double> changed_pair_weights(const l0::Quadratic_problem<double>& problem) const
  {
    std::vector<double> pair_weights(problem.pair_weights.data(),
                                     problem.pair_weights.data() + problem.pair_weights.size());
    const bool is_skipped = m_change.interleave && m_number_of_solves % 2 == 1;
    if (m_change.equation == 3 || is_skipped)
      std::fill(pair_weights.begin(), pair_weights.end(), 0.);
    else if (m_change.equation == 4) {
      // a_ik of LOR, with w_i = w_k = 1, and the weight of Eq. (4), no larger than at the radius
      for_each_pair(problem, Eigen::VectorXd::Zero(3 * Eigen::Index(problem.number_of_samples())),
                    [&](std::size_t, std::size_t e, double squared_distance) {
                      pair_weights[e] = 2 * m_change.regularization_weight
                                        * std::exp(
                                          (std::min)(squared_distance / (radius * radius), 1.));
                    });
    }
    return pair_weights;
  }

  /// Calls `f` with i, the entry of the pair (i, k) and the squared distance of the samples, moved
  /// by `x`.
  template <typename Function>
  static void for_each_pair(const l0::Quadratic_problem<double>& problem, const Eigen::VectorXd& x,
                            const Function& f)
  {
    const auto position = [&](std::size_t i) -> Eigen::Vector3d {
      return Eigen::Map<const Eigen::Vector3d>(problem.rows->origins + 3 * i)
             + x.segment<3>(3 * Eigen::Index(i));
    };
    const l0::Neighborhoods_view& neighbors = problem.self_neighbors;
    for (std::size_t i = 0; i < neighbors.size; ++i)
      for (std::size_t e = neighbors.offsets[i]; e < neighbors.offsets[i + 1]; ++e)
        f(i, e, (position(i) - position(neighbors.indices[e])).squaredNorm());
  }

  void record_densities(const l0::Quadratic_problem<double>& problem, const Eigen::VectorXd& x)
  {
    const std::size_t m = problem.number_of_samples();
    std::vector<double> sums(m, 0);
    std::size_t number_of_pairs = 0;
    for_each_pair(problem, x, [&](std::size_t i, std::size_t, double squared_distance) {
      sums[i] += std::exp(-squared_distance / squared_bandwidth);
      ++number_of_pairs;
    });
    const double mean_number = (std::max)(double(number_of_pairs) / double(m), 1.);
    m_densities.push_back({1 + sums[m / 10] / mean_number, 1 + sums[m / 2] / mean_number,
                           1 + sums[9 * m / 10] / mean_number});
  }
};

} // namespace

int main(int argc, char** argv)
{
  Arguments arguments;
  Change change;
  CLI::App& app = command_line("LOR with changes to its energy, by the paper's explicit rows");
  arguments.add_to(app);
  app.add_option("--equation", change.equation, "3, 4 or 6")->check(CLI::IsMember({3, 4, 6}));
  app
    .add_option("--neighbors", change.neighbors,
                "the original neighbors: all, those in a radius smaller by a quarter, a random "
                "half, or Algorithm 2's "
                "merged pairs")
    ->check(CLI::IsMember({"all", "smaller-radius", "random-half", "merged-pairs"}));
  app.add_flag("--interleave", change.interleave, "regularize in every second iteration only");

  return run_program(app, argc, argv, [&] {
    const std::vector<Point> points = read_positions(arguments.input);
    l0::Report report;
    Changing_solver_traits solver(change);
    Oriented_points result;
    Measurement measurement;
    measurement.phase("l0_resample", [&] {
      CGAL::l0_resample_point_set<CGAL::Sequential_tag>(
        points, std::back_inserter(result),
        CGAL::parameters::number_of_output_points(arguments.number_of_output_points)
            .sparse_linear_solver(std::ref(solver))
          | CGAL::parameters::resampling_method(l0::Method::LOR)
          | CGAL::parameters::resampling_report(&report)
          | CGAL::parameters::regularization_weight(change.regularization_weight));
    });
    Json measured = measurement.result();
    measured["densities"] = solver.densities();
    write_oriented_points(arguments.output, result);
    print_result("study_l0", arguments, points.size(), result.size(),
                 {{"equation", change.equation},
                  {"neighbors", change.neighbors},
                  {"interleave", change.interleave}},
                 measured);
  });
}
