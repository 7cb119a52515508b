# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""L0 resampling of point sets: from raw, noisy points to clean, evenly spaced, oriented ones.

    import cgal_l0
    cloud = cgal_l0.read_points("scan.ply")
    positions, normals = cgal_l0.l0_resample_point_set(cloud.points)
    cgal_l0.write_points("clean.ply", positions, normals)

The function that this package is for is l0_resample_point_set(), whose help explains every
parameter. The others turn normals to their sides, read, write and draw points, and show progress.
"""

from . import _core
from ._core import DeviceArray
from ._files import PointCloud, read_points, snapshot, write_points
from ._orienting import l0_orient_normals
from ._progress import progress_bar
from ._resampling import Cancelled, ResamplingWarning, l0_resample_point_set
from .creases import Corner, Crease, Creases
from .reports import IterationReport, Report, SolverReport, StageReport

# What help(cgal_l0) lists: the functions. They say where the classes come in.
__all__ = [
    "l0_orient_normals",
    "l0_resample_point_set",
    "progress_bar",
    "read_points",
    "snapshot",
    "write_points",
]
__version__ = _core.__version__
