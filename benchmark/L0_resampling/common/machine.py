# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a benchmark ran on."""

import platform


def processor():
    with open("/proc/cpuinfo", encoding="ascii", errors="replace") as stream:
        return next((line.split(":", 1)[1].strip() for line in stream if line.startswith("model name")), platform.machine())
