// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// $URL$
// $Id$
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s)     : The CGAL::L0_resampling authors

#ifndef CGAL_L0_RESAMPLING_NAMED_PARAMETERS_H
#define CGAL_L0_RESAMPLING_NAMED_PARAMETERS_H

#include <CGAL/license/L0_resampling.h>

#include <CGAL/L0_resampling/internal/words/require_exceptions.h>

#include <CGAL/Named_function_parameters.h>

// The named parameters that CGAL lacks, added from outside of CGAL. CGAL makes every name a member
// of one class, which nobody else can extend. So ours are
//   - free functions in CGAL::parameters, which start a chain:
//     `parameters::normal_weight(0.5).neighbor_radius(0.1)`;
//   - members of a class derived from CGAL's, which has all of CGAL's names too, so that such a
//     chain may go on with either kind;
//   - joined by `|` to a chain that CGAL's own names have started:
//     `parameters::neighbor_radius(0.1) | parameters::normal_weight(0.5)`.

namespace CGAL {

namespace internal_np {

#define CGAL_add_named_parameter(X, Y, Z)                                                          \
  enum X                                                                                           \
  {                                                                                                \
    Y                                                                                              \
  };
#include <CGAL/L0_resampling/named_parameters_interface.h>
#undef CGAL_add_named_parameter

} // namespace internal_np

namespace L0_resampling {

/// A chain of named parameters that accepts CGAL's names and this package's.
template <typename T, typename Tag, typename Base = internal_np::No_property>
struct Named_parameters : public CGAL::Named_function_parameters<T, Tag, Base>
{
  using Chain = CGAL::Named_function_parameters<T, Tag, Base>;

  Named_parameters(const T& value) : Chain(value) {}
  Named_parameters(const T& value, const Base& chain) : Chain(value, chain) {}

#define CGAL_add_named_parameter(X, Y, Z)                                                          \
  template <typename K>                                                                            \
  Named_parameters<K, internal_np::X, Chain> Z(const K& value) const                               \
  {                                                                                                \
    return Named_parameters<K, internal_np::X, Chain>(value, *this);                               \
  }
  // CGAL 6 sorts its names into five kinds, of which three differ only in how free functions are
  // made of them
#define CGAL_add_named_parameter_with_compatibility(X, Y, Z) CGAL_add_named_parameter(X, Y, Z)
#define CGAL_add_extra_named_parameter_with_compatibility(X, Y, Z) CGAL_add_named_parameter(X, Y, Z)
#define CGAL_add_named_parameter_with_compatibility_cref_only(X, Y, Z)                             \
  template <typename K>                                                                            \
  Named_parameters<std::reference_wrapper<const K>, internal_np::X, Chain> Z(const K& value) const \
  {                                                                                                \
    return Named_parameters<std::reference_wrapper<const K>, internal_np::X, Chain>(               \
      std::cref(value), *this);                                                                    \
  }
#define CGAL_add_named_parameter_with_compatibility_ref_only(X, Y, Z)                              \
  template <typename K>                                                                            \
  Named_parameters<std::reference_wrapper<K>, internal_np::X, Chain> Z(K& value) const             \
  {                                                                                                \
    return Named_parameters<std::reference_wrapper<K>, internal_np::X, Chain>(std::ref(value),     \
                                                                              *this);              \
  }
#include <CGAL/L0_resampling/named_parameters_interface.h>
#include <CGAL/STL_Extension/internal/parameters_interface.h>
#undef CGAL_add_named_parameter
#undef CGAL_add_named_parameter_with_compatibility
#undef CGAL_add_extra_named_parameter_with_compatibility
#undef CGAL_add_named_parameter_with_compatibility_cref_only
#undef CGAL_add_named_parameter_with_compatibility_ref_only
};

} // namespace L0_resampling

namespace parameters {

#define CGAL_add_named_parameter(X, Y, Z)                                                          \
  template <typename K>                                                                            \
  L0_resampling::Named_parameters<K, internal_np::X> Z(const K& value)                             \
  {                                                                                                \
    return L0_resampling::Named_parameters<K, internal_np::X>(value);                              \
  }
#include <CGAL/L0_resampling/named_parameters_interface.h>
#undef CGAL_add_named_parameter

} // namespace parameters

/// Adds the one named parameter `np` to the end of `chain`. In namespace `CGAL`, where
/// argument-dependent lookup finds it.
template <typename T, typename Tag, typename Base, typename K, typename X>
L0_resampling::Named_parameters<K, X, Named_function_parameters<T, Tag, Base>> operator|(
  const Named_function_parameters<T, Tag, Base>& chain,
  const L0_resampling::Named_parameters<K, X, internal_np::No_property>& np)
{
  return L0_resampling::Named_parameters<K, X, Named_function_parameters<T, Tag, Base>>(np.v,
                                                                                        chain);
}

} // namespace CGAL

#endif // CGAL_L0_RESAMPLING_NAMED_PARAMETERS_H
