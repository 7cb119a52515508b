# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""L0 resampling of point sets: from raw, noisy, unoriented points to clean, evenly spread, oriented ones.

    positions, normals = cgal_l0.l0_resample_point_set(points, number_of_output_points=20000)
"""

import numpy

from . import _core
from .reports import IterationReport, Report, SolverReport, StageReport, report_of

__all__ = ["Cancelled", "IterationReport", "Report", "SolverReport", "StageReport", "l0_resample_point_set"]
__version__ = _core.__version__


class Cancelled(Exception):
    """The callback has said no."""


def _array(name, numbers):
    """The numbers as an array of float32 or float64: itself, if it is one already."""
    array = numpy.asarray(numbers)
    kind = numpy.result_type(array.dtype, numpy.float32) if array.dtype.kind in "fiub" else array.dtype
    if kind not in (numpy.float32, numpy.float64):
        raise TypeError(f"{name} holds numbers of type {array.dtype}, expected those that float64 can hold")
    return array.astype(kind, copy=False)


def _choice(name, value, enumeration):
    choices = enumeration.__members__
    if value not in choices:
        raise ValueError(f"{name} is {value!r}, expected one of {', '.join(choices)}")
    return choices[value]


def l0_resample_point_set(
    points,
    normals=None,
    *,
    number_of_output_points=None,
    select_percentage=50,
    method="default",
    neighbor_radius=None,
    normal_filter_radius=None,
    sharpness_angle=15,
    number_of_normal_filter_iterations=5,
    normal_weight=0.9,
    regularization_weight=0.15,
    initial_penalty=0.1,
    maximum_penalty=2,
    penalty_growth=None,
    keep_density=False,
    viewpoint=None,
    orientation_hints=None,
    number_of_orientation_neighbors=12,
    random_seed=0,
    drop_non_finite=False,
    drop_outliers=None,
    maximum_memory=None,
    threads=None,
    device="cpu",
    callback=None,
    source_indices=False,
    feature_confidences=False,
    report=False,
):
    """Resamples a point set as CGAL::l0_resample_point_set() does, whose documentation explains every parameter.

    points and normals are arrays of shape (n, 3). Arrays of float32 and float64 are read where they are, whatever their
    strides, and must not be changed by another thread meanwhile; others are converted. The result has the number type
    of points.

    The keyword arguments are the named parameters of C++, by the same names. None stands for the default that C++ takes
    from the points or from the method. Further ones:

    method    "default", "lor" or "alor": the named parameter resampling_method
    threads   how many threads may compute; None for all. They do not change the result.
    device    "cpu"; "cuda", which raises RuntimeError where no device can be used; or "auto", whose choice the report
              explains
    callback  called with the progress in [0, 1] every now and then, in the calling thread; cancels if it returns False
    viewpoint three coordinates
    orientation_hints    an array of shape (n, 3): the named parameter orientation_hint_map
    source_indices       whether to return, for each point of the result, the index of the nearest of points
    feature_confidences  whether to return, for each point of the result, how sure it is to lie on an edge, in [0, 1]
    report    whether to return a Report too

    Returns positions and normals, then what is asked for in this order: source indices, feature confidences and the
    report. The interpreter's lock is not held meanwhile, and Ctrl-C is obeyed.

    Raises ValueError for points and parameters that cannot be used, TypeError for what is no number, MemoryError,
    Cancelled, what the callback raises, and RuntimeError if a solver or a device fails.
    """
    named = {
        "number_of_output_points": number_of_output_points,
        "select_percentage": select_percentage,
        "neighbor_radius": neighbor_radius,
        "normal_filter_radius": normal_filter_radius,
        "sharpness_angle": sharpness_angle,
        "number_of_normal_filter_iterations": number_of_normal_filter_iterations,
        "normal_weight": normal_weight,
        "regularization_weight": regularization_weight,
        "initial_penalty": initial_penalty,
        "maximum_penalty": maximum_penalty,
        "penalty_growth": penalty_growth,
        "keep_density": bool(keep_density),
        "viewpoint": None if viewpoint is None else [float(coordinate) for coordinate in viewpoint],
        "source_indices": bool(source_indices),
        "feature_confidences": bool(feature_confidences),
        "number_of_orientation_neighbors": number_of_orientation_neighbors,
        "random_seed": random_seed,
        "drop_non_finite": bool(drop_non_finite),
        "drop_outliers": None if drop_outliers is None else bool(drop_outliers),
        "maximum_memory": maximum_memory,
        "threads": threads,
        "device": _choice("device", device, _core.Device),
    }
    parameters = _core.Parameters(_choice("method", method, _core.Method))
    for name, value in named.items():
        if value is None:
            continue
        try:
            setattr(parameters, name, value)
        except TypeError:
            # A number that does not fit, such as a negative seed, is a bad value; a string is a bad type.
            error = ValueError if isinstance(value, (int, float, list)) else TypeError
            raise error(f"{name} is {value!r}, which it cannot be") from None

    result = _core.resample(
        _array("points", points),
        None if normals is None else _array("normals", normals),
        None if orientation_hints is None else _array("orientation_hints", orientation_hints),
        parameters,
        callback,
    )
    if result is None:
        raise Cancelled("cancelled by the callback")
    positions, resampled_normals, sources, confidences, members = result
    answer = [positions, resampled_normals]
    if source_indices:
        answer.append(sources)
    if feature_confidences:
        answer.append(confidences)
    if report:
        answer.append(report_of(members))
    return tuple(answer)
