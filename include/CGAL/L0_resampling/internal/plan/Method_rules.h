// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_INTERNAL_METHOD_RULES_H
#define CGAL_L0_RESAMPLING_INTERNAL_METHOD_RULES_H

#include <CGAL/L0_resampling/internal/core/Parameters.h>

#include <cstddef>

namespace CGAL {
namespace L0_resampling {
namespace internal {

/// What the methods differ in. Nothing but `rules_of()` asks for the method; without other values
/// these are the rules of LOR.
struct Method_rules
{
  bool drops_outliers = false;                         ///< unless the caller says otherwise
  double penalty_growth = Parameters().penalty_growth; ///< the same

  bool estimates_scales = false;    ///< spacing and noise of the points make the radius, and not
                                    ///< their number; it is larger or smaller by places
  bool looks_beyond_strips = false; ///< the first normals need not be those of one scan line
  std::size_t number_of_normal_refits = 0; ///< `Plan::number_of_refits`, at most
  bool uses_areas = false;                 ///< samples start evenly by area
  bool limits_jumps = false; ///< what is across a sheet or an edge is not drawn together
  bool refines = false;      ///< Algorithm 1 looks for neighbors anew in each turn

  std::size_t number_of_half_samplings = 0; ///< Algorithm 2, for solvers that need the rows
  bool interleaves_regularization = false;  ///< Section 4.2
};

inline bool is_method(Method m)
{
  return m == Method::DEFAULT || m == Method::LOR || m == Method::ALOR;
}

inline Method_rules rules_of(Method method)
{
  Method_rules rules;
  switch (method)
  {
  case Method::LOR: break;
  case Method::ALOR:
    rules.number_of_half_samplings = 2;
    rules.interleaves_regularization = true;
    break;
  case Method::DEFAULT:
    rules.drops_outliers = true;
    rules.penalty_growth = default_penalty_growth;
    rules.estimates_scales = true;
    rules.looks_beyond_strips = true;
    rules.number_of_normal_refits = number_of_normal_refits;
    rules.uses_areas = true;
    rules.limits_jumps = true;
    rules.refines = true;
    break;
  }
  return rules;
}

} // namespace internal
} // namespace L0_resampling
} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_INTERNAL_METHOD_RULES_H
