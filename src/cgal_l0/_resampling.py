# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The function l0_resample_point_set()."""

import re
import warnings

from . import _core
from ._arrays import coordinates, cuda_device_of, is_array, numbers_of_points
from .creases import creases_of
from .reports import report_of

class Cancelled(Exception):
    """Raised by a call whose callback returned False."""


class ResamplingWarning(UserWarning):
    """The result cannot be good, as Report.warnings says."""


def in_python_words(message):
    """A message of the C++ function, with its names and values as Python has them."""
    message = re.sub(r"^l0_(resample_point_set|orient_normals): ", "", message)
    message = re.sub(r"^point (\d+) has", r"points[\1] has", message)
    message = re.sub(r"\b(\w+)\((true|false)\)", lambda m: f"{m[1]}={m[2].capitalize()}", message)
    message = message.replace("--drop-non-finite", "drop_non_finite=True")
    message = message.replace("--columns", "columns")
    message = message.replace("--decimal-comma", "decimal_comma=True")
    message = message.replace("--decompress", "decompress")
    message = re.sub(r"--input-format (\w+)", r"format='\1'", message)
    message = message.replace("crease_output_iterator is given", "creases is True")
    message = message.replace("orientation_hint_map", "orientation_hints")
    return message.replace("viewpoint_map", "viewpoints").replace("2^32", "2**32")


def choice(name, value, enumeration):
    choices = enumeration.__members__
    if value not in choices:
        raise ValueError(f"{name} is {value!r}, expected one of {', '.join(map(repr, choices))}")
    return choices[value]


def floats_or_none(coordinates_or_none):
    return None if coordinates_or_none is None else [float(x) for x in coordinates_or_none]


def _device_choice(device, points):
    """Where to compute: unless the caller says it, where the points are."""
    cuda_device = cuda_device_of(points)
    if device is None:
        device = "cpu" if cuda_device is None else "cuda"
    chosen = choice("device", device, _core.Device)
    if cuda_device is not None and chosen == _core.Device.cpu:
        raise ValueError(
            f"points is on cuda:{cuda_device}, which device='cpu' cannot read: "
            "copy it to the host first, or leave device out"
        )
    return chosen


def parameters_of(method, named):
    """The parameters of a call in the form that _core takes; those that are None keep the default.

    Raises ValueError or TypeError that name the parameter.
    """
    parameters = _core.Parameters(method)
    for name, value in named.items():
        try:
            setattr(parameters, name, value)
        except TypeError:
            # A number that does not fit is a bad value; a string is a bad type.
            error = ValueError if isinstance(value, (int, float, list)) else TypeError
            expected = _core.expected[name]
            if isinstance(value, int) and expected == "a whole number":
                expected += " of at least 0 that 64 bits hold"
            raise error(f"{name} is {value!r}, expected {expected}") from None
    return parameters


def call(function, *arguments):
    """What a function of _core gives; raises its exceptions with Python's names, or Cancelled."""
    try:
        result = function(*arguments)
    except (ValueError, RuntimeError) as error:
        words = in_python_words(str(error))
        if words == str(error):   # of the callback too
            raise
        raise type(error)(words) from None
    if result is None:
        raise Cancelled("the callback returned False")
    return result


def l0_resample_point_set(
    points,
    normals=None,
    *,
    number_of_output_points=None,
    select_percentage=50,
    method="default",
    neighbor_radius=None,
    noise=None,
    normal_filter_radius=None,
    sharpness_angle=15,
    number_of_normal_filter_iterations=3,
    normal_weight=0.9,
    regularization_weight=0.15,
    initial_penalty=0.1,
    maximum_penalty=2,
    penalty_growth=None,
    keep_density=False,
    viewpoint=None,
    viewpoints=None,
    up_direction=None,
    orientation_hints=None,
    number_of_orientation_neighbors=12,
    random_seed=0,
    drop_non_finite=False,
    drop_outliers=None,
    outlier_sensitivity=None,
    maximum_memory=None,
    threads=None,
    device=None,
    callback=None,
    source_indices=False,
    feature_confidences=False,
    side_confidences=False,
    neighbor_radii=False,
    noises=False,
    position_deviations=False,
    normal_deviations=False,
    creases=False,
    outliers=False,
    report=False,
):
    """Resample raw, noisy points to clean, evenly spaced points with oriented normals.

    positions, normals = l0_resample_point_set(points, number_of_output_points=20000)

    Arrays

    points: array of shape (n, 3), the input, which is not changed. Its order does not matter.
        Arrays of float32 and float64 are read in place, whatever their strides; other threads
        must not change them during the call. Integers, float16, lists and what has __array__
        are converted. CUDA arrays (__dlpack__ or __cuda_array_interface__; float32 or float64)
        are resampled on their device, without a copy to the host.
    normals: array of shape (n, 3) or None. Normals of the points, which replace those that are
        estimated. Length and sign do not matter. None (default), and rows that are zero or not
        finite: estimated from the points.
    orientation_hints: array of shape (n, 3) or None. Vectors to whose side the normals of the
        result are turned, such as rough normals of the input. Each connected part of the result
        is turned as a whole, to the side of the majority. Lengths do not matter; a vector that
        is zero or not finite does not count. Not together with viewpoint, viewpoints or
        up_direction. Default: None.
    viewpoints: array of shape (n, 3) or None. For each point the place that it was seen from,
        which the normals face, see viewpoint. A sample takes that of the point it starts on. A
        viewpoint that is not finite, or is the point, says nothing. Default: None.

    How many points, and by which method

    number_of_output_points: int from 0 to 2**32 - 2, the exact number of points of the result.
        It may be larger than n. Default: what select_percentage gives.
    select_percentage: float in (0, 100]. Without number_of_output_points, the result has this
        percentage of the n points, rounded down, but at least one. Default: 50.
    method: "default", recommended; "lor" or "alor", the two methods of the paper.
    keep_density: bool. True: the result is as dense in each place as the input. False (default):
        it is evenly spaced.
    random_seed: int of at least 0, which chooses where the samples start. Default: 0.

    Scale and sharpness

    neighbor_radius: float above 0, a length in the unit of the points. Each sample is fitted to
        the points within this distance. Larger values remove more noise, smaller ones keep more
        detail. With method="default" it is larger or smaller where spacing or noise are. Default:
        from the spacing and the noise of the points; for "lor" and "alor" from the bounding box
        and n.
    noise: float above 0, a length in the unit of the points: the standard deviation of the points
        across the surface, where it is known; or an array of n, that of each point, on the host,
        where a number that is not above 0 or not finite says nothing. Default: estimated. Only with
        method="default".
    normal_filter_radius: float above 0, a length in the unit of the points: the radius in which
        normals are averaged. Default: neighbor_radius.
    sharpness_angle: float in (0, 90], in degrees. Normals that differ by much more are not
        averaged. Smaller values keep blunter edges. Default: 15.
    number_of_normal_filter_iterations: int from 0 to 10000, the number of times that normals are
        averaged. Default: 3.
    normal_weight: float of at least 0, the weight of sharpness against closeness to the input.
        Larger values give sharper edges and flatter faces; with method="default" up to a limit that
        grows with the noise. It has no unit. Default: 0.9.
    regularization_weight: float of at least 0. Larger values draw neighboring samples together.
        Default: 0.15.
    initial_penalty, maximum_penalty, penalty_growth: floats. The minimization solves a sequence
        of problems whose penalty grows from initial_penalty (above 0, default 0.1) by the factor
        penalty_growth (above 1; default 2.7, or 1.5 for "lor" and "alor") until it exceeds
        maximum_penalty (above 0, default 2). At most 10000 steps.

    Sides of the normals

    viewpoint: three floats or None, the place that all points were seen from, such as that of the
        scanner. Where the surface is seen at more than 10 degrees, its normals face that place;
        elsewhere they follow their neighbors. Wrong for points that were seen from elsewhere,
        such as the far side of an object. Not together with viewpoints or up_direction.
        Default: None, and normals point outwards.
    up_direction: three floats or None, for points that were seen from above, such as those of
        an airplane: as a viewpoint infinitely far in this direction. Default: None.
    number_of_orientation_neighbors: int from 3 to 1000, the number of nearest samples over which
        the side of a normal is propagated. Default: 12.

    Bad points

    drop_non_finite: bool. True: points with a coordinate that is not finite are left out and
        counted in the report. False (default): they raise ValueError.
    drop_outliers: bool. True: isolated points and small remote clusters are left out and counted
        in the report. Default: True for method="default", else False.
    outlier_sensitivity: float from 0 to 3, how readily they are: none at 0, more the larger it
        is. It sets drop_outliers to True unless that is given. Default: 1.

    Where and how it runs

    device: "cpu"; "cuda", which raises RuntimeError if no device can be used; or "auto", which
        falls back to the CPU and says why in the report. Default: where the points are.
    threads: int from 1 to 4096, the most threads that compute. It does not change the result.
        Default: all.
    maximum_memory: int, the most bytes that the call's own arrays may take; MemoryError if that
        does not suffice. With CUDA it is memory of the device. Default: no limit.
    callback: function of the progress, a float in [0, 1] that never falls. It is called in the
        calling thread. If it returns False, the call ends with Cancelled. See progress_bar().

    Further results

    source_indices: bool. True: also return, for each point of the result, the index of the
        nearest of points, as int64.
    feature_confidences: bool. True: also return, for each point of the result, how sure it is
        to be on an edge or a corner, in [0, 1].
    side_confidences: bool. True: also return, for each point of the result, how sure it is that
        its normal is on the right side, in [0, 1]; about 0.5 for a guess, such as the side of
        terrain without up_direction.
    neighbor_radii: bool. True: also return, for each point of the result, the radius that it was
        fitted with, in the unit of the points.
    noises: bool. True: also return, for each point of the result, the standard deviation of the
        points around it across the surface, as the fit measures it, in the unit of the points. It
        is too small where the noise is more than a fifth of the radius there, and 0 where no points
        fit. Only with method="default".
    position_deviations: bool. True: also return, for each point of the result, the standard
        deviation of its position along its normal, in the unit of the points. Two sheets that are
        nearer to each other than the noise are not counted in. Only with method="default".
    normal_deviations: bool. True: also return, for each point of the result, the standard
        deviation of the angle between its normal and that of the surface, in radians. Too large
        where the surface is smooth and bends, as it may have facets; details that the noise hides
        are not counted in. Only with method="default".
    creases: bool. True: also return a cgal_l0.Creases: the lines along which two faces of the
        surface meet, and the corners. Points of the result that are beside them are moved onto
        them. Only with method="default", without keep_density, and for points on the host.
    outliers: bool. True: also return which of points were left out as outliers: their indices,
        ascending, as int64. Only for points on the host.
    report: bool. True: also return a cgal_l0.Report.

    Returns a tuple: positions and normals, arrays of shape (m, 3) and of the number type of
    points, then what else is asked for, in this order: source indices, feature confidences,
    side confidences, neighbor radii, noises, position deviations, normal deviations, creases,
    outliers, report. Normals have unit length. For points on a CUDA device the arrays are of the
    type cgal_l0.DeviceArray, on that device, which torch.from_dlpack() and cupy.asarray() take
    without a copy.

    The result does not depend on the number of threads or on the run. Other Python threads run
    during the call. Ctrl-C ends it with KeyboardInterrupt.

    Warns with ResamplingWarning, once for each reason, if the result cannot be good: more than 3 %
    of the points were left out as outliers, the extent has shrunk by more than 5 %, the radius has
    hardly a point in it, or more than 5 % of the result has no compatible points near it.

    Raises ValueError for points and parameters that cannot be used, TypeError for arrays and
    parameters of a wrong type, MemoryError, Cancelled, any exception of the callback, and
    RuntimeError if the solver or the device fails.
    """
    named = {
        "number_of_output_points": number_of_output_points,
        "select_percentage": select_percentage,
        "neighbor_radius": neighbor_radius,
        "noise": None if is_array(noise) else noise,
        "normal_filter_radius": normal_filter_radius,
        "sharpness_angle": sharpness_angle,
        "number_of_normal_filter_iterations": number_of_normal_filter_iterations,
        "normal_weight": normal_weight,
        "regularization_weight": regularization_weight,
        "initial_penalty": initial_penalty,
        "maximum_penalty": maximum_penalty,
        "penalty_growth": penalty_growth,
        "keep_density": bool(keep_density),
        "viewpoint": floats_or_none(viewpoint),
        "up_direction": floats_or_none(up_direction),
        "source_indices": bool(source_indices),
        "feature_confidences": bool(feature_confidences),
        "side_confidences": bool(side_confidences),
        "neighbor_radii": bool(neighbor_radii),
        "noises": bool(noises),
        "position_deviations": bool(position_deviations),
        "normal_deviations": bool(normal_deviations),
        "creases": bool(creases),
        "outliers": bool(outliers),
        "number_of_orientation_neighbors": number_of_orientation_neighbors,
        "random_seed": random_seed,
        "drop_non_finite": bool(drop_non_finite),
        "drop_outliers": None if drop_outliers is None else bool(drop_outliers),
        "outlier_sensitivity": outlier_sensitivity,
        "maximum_memory": maximum_memory,
        "threads": threads,
        "device": _device_choice(device, points),
    }
    if creases and cuda_device_of(points) is not None:
        raise ValueError("creases is True, expected points on the host beside it")
    if outliers and cuda_device_of(points) is not None:
        raise ValueError("outliers is True, expected points on the host beside it")
    parameters = parameters_of(choice("method", method, _core.Method), named)
    arrays = coordinates(
        points=points, normals=normals, orientation_hints=orientation_hints, viewpoints=viewpoints
    )
    if cuda_device_of(points) is None:
        noises_of_points = numbers_of_points("noise", noise, arrays[0]) if is_array(noise) else None
        result = call(_core.resample, *arrays, noises_of_points, parameters, callback)
    else:
        if is_array(noise):
            raise ValueError("noise is an array, expected points on the host beside it")
        result = call(_core.resample_on_device, *arrays, parameters, callback)
    positions, resampled_normals, *further, found_outliers, found_creases, members = result
    for message in members["warnings"]:
        warnings.warn(message, ResamplingWarning, stacklevel=2)
    answer = [positions, resampled_normals]
    wanted = (
        source_indices,
        feature_confidences,
        side_confidences,
        neighbor_radii,
        noises,
        position_deviations,
        normal_deviations,
    )
    answer += [array for array, is_wanted in zip(further, wanted) if is_wanted]
    if creases:
        answer.append(creases_of(*found_creases))
    if outliers:
        answer.append(found_outliers)
    if report:
        answer.append(report_of(members))
    return tuple(answer)
