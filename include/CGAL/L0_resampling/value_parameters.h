// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

// No include guard: included once for each thing that is made of a row. A row is a named parameter
// that is a number, a count, a size (any 64 bits), a flag or a place (three coordinates):
//   CGAL_L0_value_parameter(Kind, name, default, which values x are good, what is expected)
// Those whose default depends on others of a call, or that are taken in another form, are
//   CGAL_L0_value_of_call(Kind, name, which values x are good, what is expected)
// and their default is where checked_parameters() takes them. Who includes this defines what is
// made of a row, and gives each kind the type that it is held in; of rows of what is not defined
// nothing is made.
#ifndef CGAL_L0_value_parameter
#define CGAL_L0_value_parameter(Kind, X, DEFAULT, IS_GOOD, EXPECTED)
#endif
#ifndef CGAL_L0_value_of_call
#define CGAL_L0_value_of_call(Kind, X, IS_GOOD, EXPECTED)
#endif
// clang-format off

CGAL_L0_value_of_call(Count, number_of_output_points, x < (std::numeric_limits<Index>::max)(),
                      "fewer than 2^32 - 1")
CGAL_L0_value_of_call(Number, select_percentage, x > 0 && x <= 100, "a number in (0, 100]")

/// \f$ r_p \f$, a length; 0 asks for the method's rule.
CGAL_L0_value_parameter(Number, neighbor_radius, 0, is_positive(x), "a finite length above 0")
/// \f$ r_q \f$, a length; 0 asks for the method's rule.
CGAL_L0_value_parameter(Number, normal_filter_radius, 0, is_positive(x), "a finite length above 0")
/// Standard deviation across the surface, a length; 0: it is estimated.
CGAL_L0_value_parameter(Number, noise, 0, is_positive(x), "a finite length above 0")
/// \f$ \sigma_n \f$, in degrees.
CGAL_L0_value_parameter(Number, sharpness_angle, 15, is_positive(x) && x <= 90,
                        "an angle in (0, 90] degrees")
CGAL_L0_value_parameter(Count, number_of_normal_filter_iterations, 3, x <= 10000, "at most 10000")

/// \f$ \lambda \f$
CGAL_L0_value_parameter(Number, normal_weight, default_normal_weight, is_not_negative(x),
                        "a finite number, 0 or above")
/// \f$ \alpha \f$
CGAL_L0_value_parameter(Number, regularization_weight, 0.15, is_not_negative(x),
                        "a finite number, 0 or above")
/// First \f$ \beta \f$.
CGAL_L0_value_parameter(Number, initial_penalty, 0.1, is_positive(x), "a finite number above 0")
/// Last \f$ \beta \f$ is at most this.
CGAL_L0_value_parameter(Number, maximum_penalty, 2, is_positive(x), "a finite number above 0")
/// \f$ \mu \f$; the default method has its own.
CGAL_L0_value_parameter(Number, penalty_growth, 1.5, std::isfinite(x) && x > 1,
                        "a finite number above 1")

/// Whether the density of the input is kept instead of evened out.
CGAL_L0_value_parameter(Flag, keep_density, false, true, "")
CGAL_L0_value_of_call(Flag, drop_non_finite, true, "")
CGAL_L0_value_of_call(Flag, drop_outliers, true, "")
CGAL_L0_value_of_call(Number, outlier_sensitivity, x >= 0 && x <= maximum_outlier_sensitivity,
                      "a number in [0, 3]")

CGAL_L0_value_of_call(Place, viewpoint, is_finite(x), "three finite coordinates")
CGAL_L0_value_of_call(Place, up_direction, is_finite(x), "three finite coordinates")
CGAL_L0_value_parameter(Count, number_of_orientation_neighbors, 12, x >= 3 && x <= 1000,
                        "3 to 1000")

CGAL_L0_value_parameter(Size, random_seed, 0, true, "")
/// In bytes.
CGAL_L0_value_parameter(Size, maximum_memory, (std::numeric_limits<std::size_t>::max)(), true, "")

// clang-format on
#undef CGAL_L0_value_parameter
#undef CGAL_L0_value_of_call
