// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_CLOUDCOMPARE_RESAMPLE_COMMAND_H
#define L0_CLOUDCOMPARE_RESAMPLE_COMMAND_H

#include <ccCommandLineInterface.h>

namespace l0_cloudcompare {

/// -L0_RESAMPLE of CloudCompare's command line: replaces each open cloud by its resampled points,
/// and saves them at once unless -AUTO_SAVE is OFF.
struct Resample_command : public ccCommandLineInterface::Command
{
  Resample_command();
  bool process(ccCommandLineInterface& commands) override;
};

} // namespace l0_cloudcompare

#endif // L0_CLOUDCOMPARE_RESAMPLE_COMMAND_H
