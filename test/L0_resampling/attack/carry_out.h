// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_TEST_CARRY_OUT_H
#define CGAL_L0_RESAMPLING_TEST_CARRY_OUT_H

#include "Attack.h"

#include <string>

namespace attack {

/*!
Calls the function with the attack: sequentially, in parallel, with the cloud and its lengths 2^40
times as large, and with the points in another order and the normals turned. The first must keep the
promises 1 to 5, the second equal it bit by bit (7), and so must the others up to what promise 6
allows.
\returns what is broken, as text; empty if nothing is
*/
std::string carry_out(const Attack& attack);

} // namespace attack

#endif // CGAL_L0_RESAMPLING_TEST_CARRY_OUT_H
