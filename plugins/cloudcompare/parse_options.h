// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_CLOUDCOMPARE_PARSE_OPTIONS_H
#define L0_CLOUDCOMPARE_PARSE_OPTIONS_H

#include "Resample_options.h"

#include <QStringList>

namespace l0_cloudcompare {

/// Takes from the front of `arguments` what belongs to -L0_RESAMPLE: options with the names of the
/// tool `l0_resample`, in CloudCompare's manner -KEEP_DENSITY or in the tool's --keep-density. What
/// is no such option is left to the next command.
/// \throws std::invalid_argument for a value that is missing or cannot be read, and for two options
/// that each decide the sides
Resample_options parse_options(QStringList& arguments);

} // namespace l0_cloudcompare

#endif // L0_CLOUDCOMPARE_PARSE_OPTIONS_H
