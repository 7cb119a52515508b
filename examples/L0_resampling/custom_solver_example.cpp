// A solver of your own: Eigen's conjugate gradients, preconditioned by an incomplete Cholesky
// factorization.
#include <CGAL/IO/read_points.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/l0_resample_point_set.h>
#include <Eigen/Sparse>
#include <iostream>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using namespace CGAL::L0_resampling;

//! [solver]
struct My_solver_traits // a model of L0ResamplingSolverTraits
{
  using FT = double;
  static constexpr bool needs_explicit_rows = false;

  Solver_report solve(const Quadratic_problem<double>& problem, Eigen::Ref<Eigen::VectorXd> x) const
  {
    std::vector<Eigen::Triplet<double>> entries;
    const auto add_block = [&](std::size_t i, std::size_t k, const Eigen::Matrix3d& block) {
      for (int entry = 0; entry < 9; ++entry)
        entries.emplace_back(int(3 * i) + entry / 3, int(3 * k) + entry % 3,
                             block(entry / 3, entry % 3));
    };
    const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
    const Neighborhoods_view& neighbors = problem.self_neighbors;
    for (std::size_t i = 0; i < neighbors.size; ++i)
    {
      add_block(i, i, problem.fit_weights[i] * identity);
      for (std::size_t e = neighbors.offsets[i]; e < neighbors.offsets[i + 1]; ++e)
      {
        const auto ni = problem.sample_normals.col(i),
                   nk = problem.sample_normals.col(neighbors.indices[e]);
        const Eigen::Matrix3d block = problem.pair_weights[e] * identity
                                      + problem.penalty
                                          * (ni * ni.transpose() + nk * nk.transpose());
        add_block(i, i, block);
        add_block(i, neighbors.indices[e], -block);
      }
    }
    using Matrix = Eigen::SparseMatrix<double>;
    Matrix matrix(x.size(), x.size());
    matrix.setFromTriplets(entries.begin(), entries.end());
    Eigen::ConjugateGradient<Matrix, Eigen::Lower, Eigen::IncompleteCholesky<double>> solver(
      matrix);
    solver.setTolerance(1e-4).setMaxIterations(100);
    x = solver
          .solveWithGuess(
            Eigen::Map<const Eigen::VectorXd>(problem.right_hand_side.data(), x.size()), x)
          .eval();
    if (!x.allFinite())
      throw Solver_error("The quadratic problem has values that are not finite.");
    return {std::size_t(solver.iterations()), solver.error(), solver.info() == Eigen::Success};
  }
};
//! [solver]

int main(int argc, char** argv)
{
  std::vector<Kernel::Point_3> points;
  if (!CGAL::IO::read_points(argc > 1 ? argv[1] : L0_EXAMPLE_DATA "/staircase_noisy.ply",
                             std::back_inserter(points)))
    return EXIT_FAILURE;
  std::vector<std::pair<Kernel::Point_3, Kernel::Vector_3>> result;
  CGAL::l0_resample_point_set<CGAL::Parallel_if_available_tag>(
    points, std::back_inserter(result), CGAL::parameters::sparse_linear_solver(My_solver_traits()));
  std::cout << points.size() << " points in, " << result.size() << " out" << std::endl;
  return EXIT_SUCCESS;
}
