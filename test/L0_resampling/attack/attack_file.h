// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_L0_RESAMPLING_TEST_ATTACK_FILE_H
#define CGAL_L0_RESAMPLING_TEST_ATTACK_FILE_H

#include "Attack.h"

#include <string>

namespace attack {

/// As text: the parameters that are not at their defaults, then a line for each point and its
/// normal, in hexadecimal digits.
void write_attack(const std::string& path, const Attack& attack);

/// \throws std::runtime_error if the file is not of that form
Attack read_attack(const std::string& path);

} // namespace attack

#endif // CGAL_L0_RESAMPLING_TEST_ATTACK_FILE_H
