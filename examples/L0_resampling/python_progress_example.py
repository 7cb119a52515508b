# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# [progress]
import time
import warnings

import cgal_l0

scan = cgal_l0.read_points("scan.ply")
end = time.monotonic() + 60


def go_on(progress):
    print(f"\r{progress:.0%}", end="")
    return time.monotonic() < end


try:
    with warnings.catch_warnings():
        warnings.simplefilter("error", cgal_l0.ResamplingWarning)
        positions, normals = cgal_l0.l0_resample_point_set(scan.points, callback=go_on)
except cgal_l0.Cancelled:
    print("\nnot done within a minute")
except cgal_l0.ResamplingWarning as warning:
    print("\nnot to be trusted:", warning)
# [progress]
assert len(positions) == len(scan.points) // 2
