# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The function l0_orient_normals()."""

from . import _core
from ._arrays import coordinates, cuda_device_of
from ._resampling import call, choice, floats_or_none, parameters_of
from .reports import report_of


def l0_orient_normals(
    points,
    normals=None,
    *,
    neighbor_radius=None,
    viewpoint=None,
    viewpoints=None,
    up_direction=None,
    orientation_hints=None,
    number_of_orientation_neighbors=12,
    drop_non_finite=False,
    maximum_memory=None,
    threads=None,
    device="cpu",
    callback=None,
    report=False,
):
    """Give the normals of points their side, and leave everything else as it is.

    normals = l0_orient_normals(points, normals)

    Arrays, of memory of the host, which are not changed

    points: array of shape (n, 3), as of l0_resample_point_set(). Its order does not matter.
    normals: array of shape (n, 3), of any lengths and signs. A row that is zero or not finite is
        replaced by an estimated normal of unit length; of all others at most the sign changes.
        Default: all are estimated.

    Sides, of which at most one may be given. Default: normals point outwards.

    viewpoint: three coordinates of the place that all points were seen from
    viewpoints: array of shape (n, 3), the place that each point was seen from
    up_direction: three coordinates of the way up, for points that were seen from above
    orientation_hints: array of shape (n, 3), vectors on whose side the normals shall be; each
        connected part turns to the side of the majority

    Other parameters

    neighbor_radius: length; normals are estimated from the points within 0.7 of it. Default: from
        spacing and noise of the points
    number_of_orientation_neighbors: int, nearest points over which signs are passed on. Default: 12
    drop_non_finite: bool, whether points that are not finite are passed over, with their normals as
        they are, instead of refused. Default: False
    maximum_memory: bytes that the call's own arrays may take, those on the device if it runs there.
        Default: no limit
    threads: int, the most threads to use. Default: all
    device: "cpu", "cuda", or "auto" for a CUDA device if there is one that can be used. The arrays
        are of the host's memory all the same. Default: "cpu"
    callback: function of the progress in [0, 1]; once it returns False, the call raises Cancelled.
        Default: None
    report: bool, whether a Report is returned too. Default: False

    Returns an array of shape (n, 3) with the number type of normals, or else of points; with
    report=True a tuple of it and a Report.

    The result does not depend on the order of the points, on the signs of the normals or on the
    number of threads.

    Raises ValueError for points and parameters that cannot be used, TypeError for arrays and
    parameters of a wrong type, RuntimeError if device="cuda" cannot be used or fails, MemoryError,
    Cancelled, and any exception of the callback.
    """
    cuda_device = cuda_device_of(points)
    if cuda_device is not None:
        raise ValueError(
            f"points is on cuda:{cuda_device}, expected memory of the host: copy it there first"
        )
    parameters = parameters_of(
        _core.Method.default,
        {
            "neighbor_radius": neighbor_radius,
            "viewpoint": floats_or_none(viewpoint),
            "up_direction": floats_or_none(up_direction),
            "number_of_orientation_neighbors": number_of_orientation_neighbors,
            "drop_non_finite": bool(drop_non_finite),
            "maximum_memory": maximum_memory,
            "threads": threads,
            "device": choice("device", device, _core.Device),
        },
    )
    arrays = coordinates(
        points=points, normals=normals, orientation_hints=orientation_hints, viewpoints=viewpoints
    )
    oriented, members = call(_core.orient, *arrays, parameters, callback)
    return (oriented, report_of(members)) if report else oriented
