# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Points in files, and pictures of points. The formats are those of the program l0_resample."""

from __future__ import annotations

import os
import re
import warnings
from dataclasses import dataclass, field

import numpy

from . import _core
from ._arrays import coordinates
from ._resampling import Cancelled, in_python_words


@dataclass(frozen=True, eq=False)
class PointCloud:
    """What read_points() found in a file.

    points: array of shape (n, 3), float32 if that holds all numbers of the file, else float64
    normals: array of that type and shape, or None if the file has none; unit vectors, 0
        or not finite where a point has none
    properties: dict of the other numbers of each point by their names, such as "red" or
        "intensity": arrays of shape (n,) in the number types of the file, but uint8 for the
        colors of LAS, as other formats have them
    number_of_dropped_points: those with a coordinate that is not finite, with drop_non_finite
    """

    points: numpy.ndarray
    normals: numpy.ndarray | None = None
    properties: dict[str, numpy.ndarray] = field(default_factory=dict)
    number_of_dropped_points: int = 0


def _with_python_words(function, *arguments):
    try:
        return function(*arguments)
    except (ValueError, OSError) as error:
        words = in_python_words(str(error))
        if words == str(error):   # of the callback too
            raise
        raise type(error)(words) from None


def _distinct(names):
    """The names; one that came before has a number behind it."""
    distinct = []
    for name in names:
        candidate, number = name, 2
        while candidate in distinct:
            candidate, number = f"{name}_{number}", number + 1
        distinct.append(candidate)
    return distinct


def read_points(
    path,
    *,
    format=None,
    columns=None,
    decimal_comma=False,
    drop_non_finite=False,
    decompress=None,
    callback=None,
):
    """Read the points of a file.

    cloud = cgal_l0.read_points("scan.ply")
    positions, normals = cgal_l0.l0_resample_point_set(cloud.points)

    path: str or path. The extension tells the format: .ply, .pcd, .las, .off, .xyz, .xyzn, .pwn,
        .pts, .txt, .asc, .npy, .csv or .obj, maybe before .gz.
    format: str, one of these extensions without the dot, for a file with another one.
        Default: None, by the extension.
    columns: str such as "x,y,z,red,green,blue", or a sequence of names: what the columns of a
        text, of a table or of an array are. nx, ny and nz are a normal, other names those of
        properties, and "-" is a column to leave out. Default: None; without names in the file the
        first three are coordinates, and of six the others a normal if they have unit length; a
        table has a line of names.
    decimal_comma: bool. True: numbers of a text are written as 0,5. Default: False.
    drop_non_finite: bool. True: points with a coordinate that is not finite are left out and
        counted. False (default): they raise ValueError.
    decompress: str, a command that writes a .laz file, for which {} stands, as LAS to its standard
        output, such as "laszip -i {} -olas -stdout". The shell starts it, with the name of the
        file as one word, where name or content is that of LAZ. Default: None, LAZ is refused.
    callback: as of l0_resample_point_set().

    Returns a cgal_l0.PointCloud: points, normals or None, properties, number_of_dropped_points.

    Raises ValueError with the line or byte where the file is not what it should be, OSError if
    there is no such file, MemoryError, and Cancelled. Warns of what was not read, as of points that
    LAS flags as withheld, and of x and y in degrees, which are no lengths as heights are.
    """
    os.stat(path)   # raises FileNotFoundError and its like
    if columns is not None and not isinstance(columns, str):
        columns = ",".join(columns)
    found = _with_python_words(
        _core.read_points,
        os.fsencode(path),
        format,
        columns,
        bool(decimal_comma),
        bool(drop_non_finite),
        decompress or "",
        callback,
    )
    if found is None:
        raise Cancelled("the callback returned False")
    points, normals, names, records, dropped, complaints = found
    for complaint in complaints:
        warnings.warn(in_python_words(complaint), stacklevel=2)
    fields = records.dtype.names or ()
    return PointCloud(
        points, normals, {name: records[f] for name, f in zip(_distinct(names), fields)}, dropped
    )


def _property(name, values, size):
    if re.fullmatch(r"[^\s\x00-\x1f\x7f]+", name) is None:
        raise ValueError(f"the property {name!r} has no name that a file can hold: one word")
    array = numpy.asarray(values)
    if array.shape != (size,):
        raise ValueError(f"the property {name!r} has the shape {array.shape}, expected ({size},)")
    if array.dtype.kind == "b":
        array = array.astype(numpy.uint8)
    elif array.dtype in (numpy.int64, numpy.uint64):
        narrow = numpy.int32 if array.size == 0 or array.min() < 0 else numpy.uint32
        if not numpy.array_equal(array.astype(narrow), array):
            raise ValueError(
                f"the property {name!r} has numbers beyond 32 bits, which no format holds"
            )
        array = array.astype(narrow)
    elif array.dtype == numpy.float16:
        array = array.astype(numpy.float32)
    if array.dtype.kind not in "iuf" or array.dtype.itemsize > 8:
        raise TypeError(f"the property {name!r} holds {array.dtype}, expected integers or floats")
    return array.astype(array.dtype.newbyteorder("="), copy=False)


def write_points(path, points, normals=None, properties=None, *, format=None):
    """Write points to a file: as a whole or not at all.

    cgal_l0.write_points("clean.ply", positions, normals)

    path: str or path, whose extension tells the format, as for read_points(); .csv and .obj
        are not written. A file that exists is replaced once the new one is complete; until then,
        or after an error, it stays.
    points: array of shape (n, 3). Coordinates are written in single precision if points is
        float32, else in double precision. Binary PCD is in single precision if that moves no
        point by more than a millionth of the diagonal. LAS rounds by no more than a thousandth of
        the spacing of the points.
    normals: array of shape (n, 3) or None (default), for a file without normals.
    properties: dict of further numbers of each point by their names, arrays of shape (n,), as in
        the properties of read_points(); a name is one word. PLY, PCD and LAS hold all, OFF colors
        as uint8. A warning names those that the format cannot hold. Default: None.
    format: str, as of read_points().

    Raises ValueError or TypeError for arrays that are no points, OSError if the file cannot be
    written.
    """
    points, normals = coordinates(points=points, normals=normals)
    columns = [
        (name, _property(name, values, len(points))) for name, values in (properties or {}).items()
    ]
    records = numpy.empty(len(points), [(name, values.dtype) for name, values in columns])
    for name, values in columns:
        records[name] = values
    for name in _with_python_words(
        _core.write_points, os.fsencode(path), format, points, normals, records
    ):
        warnings.warn(
            f"{os.fspath(path)}: the format has no place for the property {name!r}", stacklevel=2
        )


def snapshot(
    points,
    positions,
    normals,
    *,
    input_normals=None,
    feature_confidences=None,
    colors="shaded",
    view=None,
    up=None,
    views=1,
    path=None,
):
    """Draw the input on the left and the result on the right, seen from the same side in one light.

    image = cgal_l0.snapshot(points, positions, normals, path="picture.png")

    points: array of shape (n, 3), the input.
    positions, normals: arrays of shape (m, 3), the result.
    input_normals: array of shape (n, 3) or None (default), for which planes through points nearby
        stand in.
    feature_confidences: array of shape (m,) or None (default), from l0_resample_point_set(). With
        it, the shaded result is the redder the higher they are.
    colors: "shaded" (default), gray surfaces that are blue where normals are turned away from the
        eye, or "normals", which colors points by the direction of their normals.
    view: three floats, the direction from the points towards the eye, not zero. Default: from the
        front right or the broad side, a little above.
    up: three floats, the direction that points up, not zero. Default: z if most points of the
        result lie in a few planes that stand on z, as of buildings, else y.
    views: 1 (default) to 4, the number of rows: as `view` says, from the other side, half a turn
        around what points up, from above, and from below.
    path: str or path of a PNG file to write, or None (default).

    Returns the picture, an array of uint8 of shape (height, width, 3), which
    matplotlib.pyplot.imshow() shows.

    Raises ValueError or TypeError for arrays that are no points, OSError if the file cannot be
    written.
    """
    if colors not in ("shaded", "normals"):
        raise ValueError(f"colors is {colors!r}, expected 'shaded' or 'normals'")
    if colors == "normals" and feature_confidences is not None:
        raise ValueError("feature_confidences need colors='shaded'")
    if views not in (1, 2, 3, 4):
        raise ValueError(f"views is {views!r}, expected 1, 2, 3 or 4")
    points, input_normals = coordinates(points=points, normals=input_normals)
    positions, normals = coordinates(positions=positions, normals=normals)
    if normals is None:
        raise TypeError("normals is None, expected an array of the shape of positions")
    confidences = None
    if feature_confidences is not None:
        confidences = numpy.ascontiguousarray(feature_confidences, dtype=numpy.float32)
        if confidences.shape != (len(positions),):
            raise ValueError(
                f"feature_confidences has the shape {confidences.shape}, "
                f"expected ({len(positions)},)"
            )

    def direction(name, vector):
        if vector is None:
            return None
        numbers = [float(coordinate) for coordinate in vector]
        if len(numbers) != 3 or not numpy.isfinite(numbers).all() or not any(numbers):
            raise ValueError(
                f"{name} is {numbers}, expected three finite coordinates that are not all 0"
            )
        return numbers

    return _with_python_words(
        _core.snapshot,
        points,
        input_normals,
        positions,
        normals,
        confidences,
        colors == "normals",
        direction("view", view),
        direction("up", up),
        int(views),
        None if path is None else os.fsencode(path),
    )
