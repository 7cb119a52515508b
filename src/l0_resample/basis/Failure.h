// Copyright (c) 2026  The CGAL::L0_resampling authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef L0_RESAMPLE_FAILURE_H
#define L0_RESAMPLE_FAILURE_H

#include <stdexcept>
#include <string>

namespace l0_tool {

/// The exit statuses of the program; scripts rely on the numbers.
enum Exit_status
{
  SUCCESS = 0,
  RUN_TIME_FAILURE = 1, ///< out of memory or of time, a solver or a device failed
  WRONG_USAGE = 2,
  INPUT_REFUSED = 3,      ///< the input cannot be read, or is not what it says
  OUTPUT_NOT_WRITTEN = 4, ///< an older file of that name is still what it was
  NOT_CONVERGED = 5,      ///< only with `--strict`
  NOT_ENOUGH_MEMORY = 6,  ///< only with `--as-one`: it will not be enough another time either
  INTERRUPTED = 130,      ///< SIGINT
  TERMINATED = 143        ///< SIGTERM
};

/// Ends the program with `status`; the message is one line, "file: what" where a file is to blame.
class Failure : public std::runtime_error
{
  Exit_status m_status;

public:
  Failure(Exit_status status, const std::string& message)
    : std::runtime_error(message), m_status(status)
  {}

  Exit_status status() const { return m_status; }
};

} // namespace l0_tool

#endif // L0_RESAMPLE_FAILURE_H
