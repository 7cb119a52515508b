// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_TEST_CALL_H
#define CGAL_L0_RESAMPLING_TEST_CALL_H

#include "Attack.h"

#include <CGAL/L0_resampling/Report.h>

#include <string>
#include <vector>

namespace attack {

enum class Ending
{
  COMPLETED,
  INVALID_ARGUMENT,
  SOLVER_ERROR,
  BAD_ALLOC,
  EXCEPTION_OF_CALLER,
  ANOTHER_EXCEPTION
};

/// What one call of the function came to.
struct Answer
{
  Ending ending = Ending::COMPLETED;
  std::string message;                 // of the exception
  std::vector<Vector> points, normals; // what was written
  std::vector<std::size_t> sources;    // likewise, if asked for
  std::vector<float> confidences;      // likewise
  bool input_is_unchanged = true;
  bool progress_is_sound = true; // in [0, 1] and never falling
  CGAL::L0_resampling::Report report;
};

/// The caller's point of view and way up, which is some other one if the parameters have none.
Vector viewpoint(const Parameters& parameters);
Vector up_direction(const Parameters& parameters);

/// Calls the function as the attack says: sequentially, or in parallel where TBB was found and the
/// solver is the package's own.
Answer call(const Attack& attack, bool in_parallel);

} // namespace attack

#endif // CGAL_L0_RESAMPLING_TEST_CALL_H
