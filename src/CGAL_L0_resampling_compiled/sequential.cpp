// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

// The stages for `Sequential_tag`, with the default solver.

#include "compiled_templates.h"

#include <CGAL/L0_resampling/Block_chebyshev_solver_traits.h>
#include <CGAL/L0_resampling/Block_conjugate_gradient_solver_traits.h>

namespace CGAL {
namespace L0_resampling {

template class Block_chebyshev_solver_traits<float, Sequential_tag>;
template class Block_conjugate_gradient_solver_traits<float, Sequential_tag>;
template class Block_chebyshev_solver_traits<double, Sequential_tag>;
template class Block_conjugate_gradient_solver_traits<double, Sequential_tag>;

namespace internal {

CGAL_L0_COMPILED_TEMPLATES(Sequential_tag, float)
CGAL_L0_COMPILED_TEMPLATES(Sequential_tag, double)
CGAL_L0_COMPILED_TEMPLATES_OF_TAG(Sequential_tag)

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL
