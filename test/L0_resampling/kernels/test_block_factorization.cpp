// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The 3 x 3 blocks of the preconditioner against Eigen's dense arithmetic.

#include "test_support.h"

#include <CGAL/L0_resampling/internal/kernels/block_factorization.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <limits>

namespace {

using test::Generator;
using test::Vector;
namespace internal = CGAL::L0_resampling::internal;

template <typename FT>
internal::Block_factorization<FT> factorize(const Eigen::Matrix3d& block)
{
  return internal::factorize_block({FT(block(0, 0)), FT(block(0, 1)), FT(block(0, 2)),
                                    FT(block(1, 1)), FT(block(1, 2)), FT(block(2, 2))});
}

/// weight * I plus a few normals, as in `Quadratic_problem`; `scale` takes it to where a
/// determinant would underflow.
template <typename FT>
void test_products(double weight, double scale, Generator& generator)
{
  for (int trial = 0; trial < 100; ++trial)
  {
    Eigen::Matrix3d block = scale * weight * Eigen::Matrix3d::Identity();
    for (int i = 0; i < 5; ++i)
    {
      const Vector n = test::random_unit_vector(generator);
      block += scale * n * n.transpose();
    }
    const auto factors = factorize<FT>(block);
    const Eigen::Matrix<FT, 3, 1> x = test::random_unit_vector(generator).cast<FT>();
    Eigen::Matrix<FT, 3, 1> product, back;
    internal::multiply_block(factors, x.data(), product.data());
    const double tolerance = 100 * double(std::numeric_limits<FT>::epsilon());
    CHECK(
      (product.template cast<double>() / scale - block / scale * x.template cast<double>()).norm()
      < tolerance);

    internal::solve_block(factors, product.data(), back.data());
    const Eigen::Matrix3d inverse = (block / scale).inverse();
    CHECK((back - x).template cast<double>().norm() < tolerance * 10 * inverse.norm());
    internal::solve_block(factors, x.data(), back.data());
    const Vector expected = inverse * x.template cast<double>();
    CHECK((back.template cast<double>() * scale - expected).norm()
          < tolerance * inverse.norm() * 10 * expected.norm());
  }
}

/// All normals alike and next to no weight: rounding leaves nothing of the small pivots. Then too
/// the factors are those of a positive definite block, of D but for what pivots are held at.
void test_pivots_are_held(Generator& generator)
{
  const double held = 4096 * std::numeric_limits<double>::epsilon(); // of the trace, which is 1
  for (int trial = 0; trial < 1000; ++trial)
  {
    const Vector n = test::random_unit_vector(generator);
    const Eigen::Matrix3d block = 1e-20 * Eigen::Matrix3d::Identity() + n * n.transpose();
    const auto factors = factorize<double>(block);
    const Vector x = test::random_unit_vector(generator);
    Vector z;
    internal::solve_block(factors, x.data(), z.data());
    CHECK(z.allFinite() && x.dot(z) > 0);
    for (const double pivot : factors.pivots)
      CHECK(pivot > 0.99 * held);
    Eigen::Matrix3d product;
    for (Eigen::Index c = 0; c < 3; ++c)
    {
      const Vector unit = Vector::Unit(c);
      internal::multiply_block(factors, unit.data(), product.col(c).data());
    }
    CHECK((product - block).norm() < 2 * held);
  }
}

} // namespace

int main()
{
  Generator generator(3);
  for (const double scale : {1., 1e-15, 1e15})
  {
    test_products<double>(0.1, scale, generator);
    test_products<float>(0.1, scale, generator);
  }
  test_pivots_are_held(generator);
  return test::result();
}
