# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""l0_orient_normals() changes signs only, passes every parameter on, and says what is wrong."""

import cgal_l0
import numpy
import pytest
from cgal_l0 import l0_orient_normals


@pytest.fixture(scope="module")
def sphere():
    generator = numpy.random.default_rng(1)
    points = generator.normal(size=(3000, 3))
    return points / numpy.linalg.norm(points, axis=1, keepdims=True)


@pytest.fixture(scope="module")
def turned(sphere):
    return sphere * 3 * numpy.random.default_rng(2).choice([-1, 1], (len(sphere), 1))


@pytest.mark.parametrize("kind", [numpy.float32, numpy.float64])
def test_only_signs_change(sphere, turned, kind):
    points, given = sphere.astype(kind), turned.astype(kind)
    before = points.copy(), given.copy()
    normals, report = l0_orient_normals(points, given, report=True)
    assert normals.dtype == kind and numpy.array_equal(normals, (sphere * 3).astype(kind))
    assert numpy.array_equal(points, before[0]) and numpy.array_equal(given, before[1])
    assert report.number_of_input_points == len(points) and report.oriented_share == 1
    assert l0_orient_normals(points.astype(numpy.float32), turned).dtype == numpy.float64
    assert numpy.array_equal(l0_orient_normals(points, given, threads=1), normals)


def test_missing_normals_are_estimated(sphere, turned):
    normals = l0_orient_normals(sphere)
    assert ((normals * sphere).sum(axis=1) > 0.9).all()
    assert numpy.allclose(numpy.linalg.norm(normals, axis=1), 1)
    holes = turned.copy()
    holes[5] = 0
    holes[6] = numpy.nan
    normals = l0_orient_normals(sphere, holes)
    assert ((normals[5:7] * sphere[5:7]).sum(axis=1) > 0.9).all()
    assert numpy.array_equal(numpy.delete(normals, [5, 6], 0),
                             numpy.delete(sphere * 3, [5, 6], 0))


def test_device(sphere, turned):
    normals, report = l0_orient_normals(sphere, turned, device="auto", report=True)
    assert numpy.array_equal(normals, 3 * sphere) and report.device_reason != "asked for"
    assert l0_orient_normals(sphere, report=True)[1].device == "cpu"
    if report.device == "cpu":
        with pytest.raises(RuntimeError, match="^device='cuda'"):
            l0_orient_normals(sphere, device="cuda")


def test_sides(sphere, turned):
    for inwards in ({"viewpoint": (0, 0, 0.1)}, {"viewpoints": 0 * sphere},
                    {"orientation_hints": -sphere}):
        normals, report = l0_orient_normals(sphere, turned, report=True, **inwards)
        assert numpy.array_equal(normals, -3 * sphere) and report.hinted_share == 1
    plane = sphere * (1, 1, 0)
    assert (l0_orient_normals(plane, up_direction=(0, 0, -1))[:, 2] < 0).all()


def test_parameters_are_passed_on(sphere):
    assert not numpy.array_equal(l0_orient_normals(sphere),
                                 l0_orient_normals(sphere, neighbor_radius=0.5))
    holes = sphere.copy()
    holes[7, 1] = numpy.inf
    with pytest.raises(ValueError, match=r"^points\[7\] has"):
        l0_orient_normals(holes)
    normals = l0_orient_normals(holes, -sphere, drop_non_finite=True)
    assert numpy.array_equal(normals[7], -sphere[7]) and (normals[8:] == sphere[8:]).all()
    with pytest.raises(MemoryError):
        l0_orient_normals(sphere, maximum_memory=1000)
    with pytest.raises(cgal_l0.Cancelled):
        l0_orient_normals(sphere, callback=lambda share: False)
    assert l0_orient_normals(numpy.empty((0, 3))).shape == (0, 3)


@pytest.mark.parametrize("error, message, named", [
    (ValueError, "^number_of_orientation_neighbors is 2", {"number_of_orientation_neighbors": 2}),
    (ValueError, "^neighbor_radius is -1", {"neighbor_radius": -1}),
    (TypeError, "^neighbor_radius is 'x'", {"neighbor_radius": "x"}),
    (ValueError, "^threads is 0", {"threads": 0}),
    (ValueError, "^device is 'gpu', expected one of 'cpu', 'cuda', 'auto'", {"device": "gpu"}),
    (ValueError, "no up_direction beside it", {"viewpoint": (0, 0, 0), "up_direction": (0, 0, 1)}),
    (ValueError, r"^normals is .* expected shape \(3000, 3\)", {"normals": [[0, 0, 1]]}),
])
def test_what_cannot_be_is_refused(sphere, error, message, named):
    with pytest.raises(error, match=message):
        l0_orient_normals(sphere, **named)
