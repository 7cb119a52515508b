# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The creases of a result of l0_resample_point_set()."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from numpy import float64, int64
from numpy.typing import NDArray


@dataclass(frozen=True, eq=False)
class Crease:
    """A line of k points of the result along which two faces meet.

    points: array of shape (k,), int64: their indices, in the order along the crease
    tangents: array of shape (k, 3): unit vectors in the direction of points
    normals: array of shape (k, 2, 3): the unit normals of the face to the left, as one who walks
        along the crease outside of the surface sees it, and of that to the right
    angles: array of shape (k,): between the two normals, in degrees
    is_closed: bool, whether the first point follows the last one again
    is_convex: bool, whether it is as the edges of a box, and not as its inner edges
    confidence: float in [0, 1], the share of its length where samples of both faces are seen
    """

    points: NDArray[int64]
    tangents: NDArray[float64]
    normals: NDArray[float64]
    angles: NDArray[float64]
    is_closed: bool
    is_convex: bool
    confidence: float


@dataclass(frozen=True, eq=False)
class Corner:
    """A point of the result that creases meet at, or that one turns at sharply.

    point: int, its index
    normals: array of shape (f, 3): the unit normals of the f faces that meet there
    """

    point: int
    normals: NDArray[float64]


@dataclass(frozen=True, eq=False)
class Creases:
    """The creases and the corners of a result.

    lines: tuple of Crease
    corners: tuple of Corner
    """

    lines: tuple[Crease, ...]
    corners: tuple[Corner, ...]


def creases_of(lines: list[dict[str, Any]], corners: list[dict[str, Any]]) -> Creases:
    """The creases that _core gives as dictionaries."""
    return Creases(tuple(Crease(**line) for line in lines),
                   tuple(Corner(**corner) for corner in corners))
