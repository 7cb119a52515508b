# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""cgal_l0 gives what the C++ function gives, wherever its arrays lie, and passes every parameter
on."""

import dataclasses
import inspect
import json
import os
import pathlib
import re
import subprocess
import sys
import tracemalloc
import warnings

import cgal_l0
import numpy
import pytest
from cgal_l0 import l0_resample_point_set


def same(result, other):
    """Bitwise, but for NaN, which is in no result."""
    return all(a.dtype == b.dtype and numpy.array_equal(a, b) for a, b in zip(result, other))


@pytest.mark.parametrize("options, named", [
    ([], {}),
    (["--points", 777], {"number_of_output_points": 777}),
    (["--percentage", 12.5], {"select_percentage": 12.5}),
    (["--method", "lor"], {"method": "lor"}),
    (["--method", "alor"], {"method": "alor"}),
    (["--neighbor-radius", 0.2], {"neighbor_radius": 0.2}),
    (["--noise", 0.01], {"noise": 0.01}),
    (["--normal-weight", 0.1], {"normal_weight": 0.1}),
    (["--sharpness-angle", 40], {"sharpness_angle": 40}),
    (["--seed", 5], {"random_seed": 5}),
    (["--keep-density"], {"keep_density": True}),
    (["--outlier-sensitivity", 3], {"outlier_sensitivity": 3}),
    (["--method", "lor", "--outlier-sensitivity", 3], {"method": "lor", "outlier_sensitivity": 3}),
    (["--viewpoint", "0.5,0.5,0.5"], {"viewpoint": (0.5, 0.5, 0.5)}),
    (["--up", "0,0,-2"], {"up_direction": (0, 0, -2)}),
])
def test_equals_the_program_bitwise(cube, tool, options, named):
    positions, normals, _ = tool(cube, *options)
    result = l0_resample_point_set(cube, **named)
    assert same(result, (positions, normals))
    if named:
        assert not same(result, l0_resample_point_set(cube))


def test_equals_the_program_with_normals(cube, cube_normals, tool):
    positions, normals, _ = tool(cube, "--use-normals", normals=cube_normals)
    result = l0_resample_point_set(cube, cube_normals)
    assert same(result, (positions, normals))
    assert not same(result, l0_resample_point_set(cube))
    # zeros and ones
    assert same(result, l0_resample_point_set(cube, cube_normals.astype(numpy.float32)))


def test_orientation_hints(cube, cube_normals, tool):
    outward = cube_normals * numpy.sign((cube_normals * cube).sum(axis=1, keepdims=True))
    positions, normals, _ = tool(cube, "--orient-by-normals", normals=-outward)
    result = l0_resample_point_set(cube, orientation_hints=-outward, report=True)
    assert same(result[:2], (positions, normals))
    assert result[2].hinted_share == 1
    assert same(l0_resample_point_set(cube, orientation_hints=outward), (positions, -normals))
    refusal = "viewpoint is given, expected no orientation_hints beside it"
    with pytest.raises(ValueError, match=refusal):
        l0_resample_point_set(cube, viewpoint=(0, 0, 0), orientation_hints=outward)
    with pytest.raises(ValueError, match="viewpoint"):
        l0_resample_point_set(cube, viewpoint=(0, 0))
    with pytest.raises(ValueError, match="orientation_hints"):
        l0_resample_point_set(cube, orientation_hints=outward[1:])


def test_viewpoints(cube):
    inside = numpy.broadcast_to([0.1, 0.0, 0.2], cube.shape)
    inwards = l0_resample_point_set(cube, viewpoints=inside, report=True)
    assert inwards[2].hinted_share == 1
    assert ((inwards[0] - inside[0]) * inwards[1]).sum(axis=1).max() < 0
    assert same(inwards[:2], l0_resample_point_set(cube, viewpoint=inside[0]))
    nowhere = numpy.full(cube.shape, numpy.inf)
    outwards = l0_resample_point_set(cube, viewpoints=nowhere, report=True)
    assert outwards[2].hinted_share == 0
    assert same(outwards[:2], l0_resample_point_set(cube))
    for sides in (
        {"viewpoint": (0, 0, 0), "viewpoints": inside},
        {"up_direction": (0, 0, 1), "viewpoints": inside},
        {"viewpoint": (0, 0, 0), "up_direction": (0, 0, 1)},
    ):
        refusal = "{} is given, expected no {} beside it".format(*sides)
        with pytest.raises(ValueError, match=refusal):
            l0_resample_point_set(cube, **sides)
    with pytest.raises(ValueError, match="up_direction is 0, 0, 0, expected a direction"):
        l0_resample_point_set(cube, up_direction=(0, 0, 0))
    with pytest.raises(ValueError, match="up_direction"):
        l0_resample_point_set(cube, up_direction=(0, 1))
    with pytest.raises(ValueError, match="viewpoints"):
        l0_resample_point_set(cube, viewpoints=inside[1:])


@pytest.mark.parametrize("number_type", [numpy.float32, numpy.float64])
def test_source_indices_and_feature_confidences(cube, number_type):
    points = cube.astype(number_type)
    plain = l0_resample_point_set(points)
    positions, normals, sources, confidences, report = l0_resample_point_set(
        points, source_indices=True, feature_confidences=True, report=True)
    assert same(plain, (positions, normals)) and report.number_of_output_points == len(positions)
    assert sources.dtype == numpy.int64 and sources.shape == (len(positions),)
    p, q = positions.astype(float), points.astype(float)
    for rows in numpy.array_split(numpy.arange(len(p)), 50):  # all at once are no longer in a cache
        distances = numpy.sqrt(sum((p[rows, None, k] - q[None, :, k]) ** 2 for k in range(3)))
        assert numpy.array_equal(distances[numpy.arange(len(rows)), sources[rows]],
                                 distances.min(axis=1))
    assert confidences.dtype == number_type and confidences.shape == (len(positions),)
    assert confidences.min() >= 0 and confidences.max() <= 1
    assert numpy.array_equal(l0_resample_point_set(points, source_indices=True)[2], sources)
    assert numpy.array_equal(l0_resample_point_set(points, feature_confidences=True)[2],
                             confidences)


@pytest.mark.parametrize("number_type", [numpy.float32, numpy.float64])
def test_creases(number_type):
    random = numpy.random.default_rng(4)
    points = random.uniform(-0.5, 0.5, size=(20000, 3))
    axes = random.integers(3, size=20000)
    points[numpy.arange(20000), axes] = random.choice([-0.5, 0.5], size=20000)
    points = (points + 0.005 * random.normal(size=points.shape)).astype(number_type)
    positions, normals, creases, report = l0_resample_point_set(points, creases=True, report=True)
    assert isinstance(creases, cgal_l0.Creases)
    assert len(positions) == 10000 and len(creases.lines) == 12 and len(creases.corners) == 8
    for line in creases.lines:
        k = len(line.points)
        assert line.points.dtype == numpy.int64 and line.tangents.shape == (k, 3)
        assert line.normals.shape == (k, 2, 3) and line.angles.shape == (k,)
        assert line.is_convex and not line.is_closed and 0.8 < line.confidence <= 1
        offs = numpy.sort(abs(abs(positions[line.points]) - 0.5), axis=1)[:, :2]
        assert offs.max() < report.sample_spacing
        cosines = (line.normals[:, 0] * line.normals[:, 1]).sum(axis=1)
        assert numpy.allclose(numpy.cos(numpy.radians(line.angles)), cosines, atol=1e-5)
        assert ((normals[line.points][:, None] * line.normals).sum(axis=2) > 0.5).all()
    for corner in creases.corners:
        assert corner.normals.shape == (3, 3)
        assert abs(abs(positions[corner.point]) - 0.5).max() < report.sample_spacing
    with pytest.raises(ValueError, match="creases is True, expected the default method"):
        l0_resample_point_set(points, method="lor", creases=True)


@pytest.mark.parametrize("number_type", [numpy.float32, numpy.float64])
def test_radii_and_noises(number_type):
    random = numpy.random.default_rng(3)
    points = random.uniform(size=(20000, 3))
    noise = numpy.where(points[:, 0] < 0.5, 0.001, 0.004)
    points[:, 2] = noise * random.normal(size=20000)
    points = points.astype(number_type)
    options = {"select_percentage": 20}
    positions, _, radii, noises, report = l0_resample_point_set(
        points, neighbor_radii=True, noises=True, report=True, **options)
    assert radii.dtype == noises.dtype == number_type and noises.shape == (4000,)
    assert radii.min() >= 0.999 * report.least_neighbor_radius
    assert radii.max() <= 1.001 * report.largest_neighbor_radius
    for is_there, truth in ((positions[:, 0] < 0.35, 0.001), (positions[:, 0] > 0.65, 0.004)):
        assert abs(noises[is_there].mean() - truth) < 0.15 * truth
    assert numpy.array_equal(l0_resample_point_set(points, noises=True, **options)[2], noises)
    with pytest.raises(ValueError, match="noise_map is given, expected the default method"):
        l0_resample_point_set(points, method="lor", noises=True)


@pytest.mark.parametrize("number_type", [numpy.float32, numpy.float64, list])
def test_noise_of_points(number_type):
    random = numpy.random.default_rng(3)
    directions = random.normal(size=(20000, 3))
    directions /= numpy.linalg.norm(directions, axis=1)[:, None]
    noises = 0.01 * 3**(directions[:, 2] / 2)
    points = directions * (1 + noises * random.normal(size=20000))[:, None]
    given = noises.tolist() if number_type is list else noises.astype(number_type)

    def distance(noise):
        positions, _, report = l0_resample_point_set(points, noise=noise, report=True)
        off = abs(numpy.linalg.norm(positions, axis=1) - 1).mean()
        return off, report.estimated_noise, positions

    with_each, median, _ = distance(given)
    assert abs(median - numpy.median(noises)) < 1e-6
    assert with_each < 0.9 * distance(median)[0] and with_each < 0.9 * distance(None)[0]
    same = distance(numpy.full(20000, 0.01, dtype=numpy.float64))[2]
    assert numpy.array_equal(same, distance(0.01)[2])
    assert numpy.array_equal(same, distance(numpy.float64(0.01))[2])


def test_refused_noises_of_points(cube):
    points = cube
    for noise in (numpy.ones(3), numpy.ones((len(points), 1)), numpy.ones((2, len(points)))):
        with pytest.raises(ValueError, match=rf"noise is a float64 array .* \({len(points)},\)"):
            l0_resample_point_set(points, noise=noise)
    with pytest.raises(TypeError, match="noise is a .* expected numbers that float64 can hold"):
        l0_resample_point_set(points, noise=["a"] * len(points))
    with pytest.raises(ValueError, match="point_noise_map is given, expected the default method"):
        l0_resample_point_set(points, noise=numpy.ones(len(points)), method="lor")


@pytest.mark.parametrize("number_type", [numpy.float32, numpy.float64])
def test_deviations(number_type):
    random = numpy.random.default_rng(3)
    points = random.normal(size=(10000, 3))
    points /= numpy.linalg.norm(points, axis=1)[:, None]
    points = (points + 0.01 * random.normal(size=points.shape)).astype(number_type)
    positions, normals, of_positions, of_normals = l0_resample_point_set(
        points, position_deviations=True, normal_deviations=True)
    assert of_positions.dtype == of_normals.dtype == number_type
    assert of_positions.shape == of_normals.shape == (5000,)
    heights = numpy.linalg.norm(positions, axis=1)
    cosines = numpy.abs((positions * normals).sum(axis=1)) / heights
    angles = numpy.arccos(numpy.minimum(cosines, 1))
    # what bends smoothly is known better than the deviation of a normal says
    for errors, deviations, least in ((heights - 1, of_positions, 0.1), (angles, of_normals, 0.03)):
        assert least < numpy.sqrt(numpy.mean((errors / deviations) ** 2)) < 1.4
    assert numpy.array_equal(l0_resample_point_set(points, normal_deviations=True)[2], of_normals)
    with pytest.raises(ValueError, match="normal_deviation_map is given, expected the default"):
        l0_resample_point_set(points, method="lor", normal_deviations=True)


def test_single_precision(cube, tool):
    single = cube.astype(numpy.float32)
    positions, normals = l0_resample_point_set(single)
    assert positions.dtype == normals.dtype == numpy.float32
    expected = tool(single.astype(numpy.float64))
    assert same((positions, normals),
                (expected[0].astype(numpy.float32), expected[1].astype(numpy.float32)))


def test_every_other_parameter_arrives(cube):
    def report_of(**named):
        return l0_resample_point_set(cube, report=True, **named)[2]

    default = report_of()
    assert report_of(normal_filter_radius=0.3).normal_filter_radius == pytest.approx(0.3, rel=1e-12)
    assert report_of(neighbor_radius=0.2).neighbor_radius == pytest.approx(0.2, rel=1e-12)
    assert report_of(initial_penalty=0.5).iterations[0].penalty == 0.5
    last = report_of(maximum_penalty=0.2).iterations[-1]
    assert last.penalty <= 0.2 < default.iterations[-1].penalty
    assert report_of(penalty_growth=4).iterations[1].penalty == pytest.approx(0.4)
    assert report_of(regularization_weight=0).iterations[0].regularization_energy == 0
    assert default.iterations[0].regularization_energy > 0
    for named in ({"number_of_normal_filter_iterations": 1}, {"regularization_weight": 1}):
        assert not same(l0_resample_point_set(cube, **named), l0_resample_point_set(cube))
    with pytest.raises(ValueError, match="number_of_orientation_neighbors is 2"):
        l0_resample_point_set(cube, number_of_orientation_neighbors=2)
    with pytest.raises(MemoryError):
        l0_resample_point_set(cube, maximum_memory=1000)


def test_defaults_are_those_of_the_function(cube):
    signature = inspect.signature(l0_resample_point_set)
    ours = {name: p.default for name, p in signature.parameters.items()}
    include = pathlib.Path(os.environ["L0_SOURCE"], "include/CGAL/L0_resampling")
    table = (include / "value_parameters.h").read_text()
    rows = re.findall(r"(?m)^CGAL_L0_value_parameter\(\w+, (\w+), ([^,]+),", table)
    numbers = dict(re.findall(r"constexpr double (\w+) = (.*);", (include / "tags.h").read_text()))
    compared = {name: json.loads(numbers.get(default, default))
                for name, default in rows if ours[name] is not None}
    assert compared == {name: ours[name] for name in compared}
    assert {"sharpness_angle", "normal_weight", "keep_density", "random_seed"} <= set(compared)
    for name in ("select_percentage", *(name for name, _ in rows)):
        assert same(l0_resample_point_set(cube), l0_resample_point_set(cube, **{name: None})), name
    for method, growth in {"default": 2.7, "lor": 1.5}.items():
        assert same(l0_resample_point_set(cube, method=method),
                    l0_resample_point_set(cube, method=method, penalty_growth=growth))


def layouts_of(array):
    n = len(array)
    wide = numpy.zeros((2 * n, 7), array.dtype)
    wide[::2, 1:7:2] = array
    read_only = array.copy()
    read_only.flags.writeable = False
    packed = numpy.zeros(n, [("tag", "u1"), ("point", array.dtype, 3)])
    packed["point"] = array
    return {
        "column by column": numpy.asfortranarray(array),
        "with gaps": wide[::2, 1:7:2],
        "backwards": array[::-1, ::-1].copy()[::-1, ::-1],
        "read-only": read_only,
        "unaligned": packed["point"],
    }


@pytest.mark.parametrize("number_type", [numpy.float32, numpy.float64])
def test_layouts_are_read_in_place(cube, cube_normals, number_type):
    points, normals = cube.astype(number_type), cube_normals.astype(number_type)
    expected = l0_resample_point_set(points, normals)
    for (name, strided_points), strided_normals in zip(layouts_of(points).items(),
                                                       layouts_of(normals).values()):
        tracemalloc.start()   # sees what NumPy allocates
        result = l0_resample_point_set(strided_points, strided_normals)
        peak = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        assert same(result, expected), name
        assert peak < points.nbytes / 4, f"{name}: {peak} bytes"


def test_the_input_stays_as_it_is(cube):
    points = cube.copy()
    l0_resample_point_set(points)
    assert numpy.array_equal(points, cube)


def test_other_number_types_are_converted():
    steps = numpy.array([[x, y, x * y % 3] for x in range(20) for y in range(20)])
    expected = l0_resample_point_set(steps.astype(numpy.float64))
    assert same(l0_resample_point_set(steps), expected)
    assert same(l0_resample_point_set(steps.tolist()), expected)
    assert same(l0_resample_point_set(steps.astype(">f8")), expected)
    assert same(l0_resample_point_set(steps.astype(">f4")),
                l0_resample_point_set(steps.astype(numpy.float32)))
    for wrong in (steps.astype(complex), steps.astype(str), steps.astype(object),
                  steps.astype(numpy.longdouble)):
        with pytest.raises(TypeError,
                           match="points is a .* array .*, expected numbers that float64"):
            l0_resample_point_set(wrong)


def test_the_result_lives_alone(cube):
    positions, normals = l0_resample_point_set(cube)
    again = l0_resample_point_set(cube)
    assert positions.flags.c_contiguous and positions.flags.writeable and positions.flags.aligned
    kept = positions[:10].copy(), positions[:10]
    positions[10:] = 0
    del positions
    assert numpy.array_equal(*kept)
    assert numpy.array_equal(normals, again[1])


def test_threads_do_not_matter(cube):
    assert same(l0_resample_point_set(cube, threads=1), l0_resample_point_set(cube, threads=3))
    assert same(l0_resample_point_set(cube, threads=1), l0_resample_point_set(cube))


def test_small_inputs():
    for number_type in (numpy.float32, numpy.float64):
        positions, normals = l0_resample_point_set(numpy.zeros((0, 3), number_type))
        assert positions.shape == normals.shape == (0, 3) and positions.dtype == number_type
    positions, normals = l0_resample_point_set([[1, 2, 3]])
    assert positions.tolist() == [[1, 2, 3]] and normals.shape == (1, 3)


def test_drop_non_finite(cube):
    bad = numpy.vstack([cube, [[numpy.nan, 0, 0], [0, numpy.inf, 0]]])
    expected = r"points\[6000\] has a coordinate that is not finite .*; drop_non_finite=True leaves"
    with pytest.raises(ValueError, match=expected):
        l0_resample_point_set(bad)
    *result, report = l0_resample_point_set(bad, drop_non_finite=True, report=True)
    assert report.number_of_dropped_points == 2
    assert same(result, l0_resample_point_set(cube))


def test_drop_outliers(cube):
    outliers = numpy.random.default_rng(1).uniform(-3, 3, (300, 3)) * numpy.ptp(cube)
    scattered = numpy.vstack([cube, outliers])
    *kept, report = l0_resample_point_set(scattered, drop_outliers=False, report=True)
    assert report.number_of_outliers == 0
    *result, report = l0_resample_point_set(scattered, report=True)
    assert 250 < report.number_of_outliers <= 300
    *with_outliers, found = l0_resample_point_set(scattered, outliers=True)
    assert same(result, with_outliers) and found.dtype == numpy.int64
    assert len(found) == report.number_of_outliers and found.min() >= len(cube)
    assert (numpy.diff(found) > 0).all()
    assert numpy.abs(result[0]).max() < numpy.abs(kept[0]).max() / 2
    assert same(result, l0_resample_point_set(scattered, drop_outliers=True))
    assert same(result, l0_resample_point_set(scattered, outlier_sensitivity=1))
    assert same(kept, l0_resample_point_set(scattered, outlier_sensitivity=0))
    with pytest.raises(ValueError, match="outlier_sensitivity is 4"):
        l0_resample_point_set(scattered, outlier_sensitivity=4)
    assert l0_resample_point_set(scattered, method="lor", report=True)[2].number_of_outliers == 0


@pytest.mark.parametrize("error, message, named", [
    (ValueError, "number_of_output_points is -1", {"number_of_output_points": -1}),
    (ValueError, "number_of_output_points is 2.5", {"number_of_output_points": 2.5}),
    (ValueError, "number_of_output_points is 1000000000000000000000",
     {"number_of_output_points": 10**21}),
    (ValueError, "select_percentage is 0", {"select_percentage": 0}),
    (ValueError, "select_percentage is nan", {"select_percentage": float("nan")}),
    (ValueError, "neighbor_radius is -1", {"neighbor_radius": -1}),
    (ValueError, "normal_filter_radius is 0", {"normal_filter_radius": 0.0}),
    (ValueError, "sharpness_angle is 91", {"sharpness_angle": 91}),
    (ValueError, "normal_weight is -1", {"normal_weight": -1}),
    (ValueError, "penalty_growth is 1", {"penalty_growth": 1}),
    (ValueError, "random_seed is -1", {"random_seed": -1}),
    (ValueError, "threads is 0", {"threads": 0}),
    (ValueError, "threads is 5000", {"threads": 5000}),
    (ValueError, "method is 'best'", {"method": "best"}),
    (ValueError, "device is 'tpu'", {"device": "tpu"}),
    (TypeError, "neighbor_radius is '1'", {"neighbor_radius": "1"}),
    (TypeError, "nonsense", {"nonsense": 1}),
    (ValueError, r"normals is .* of shape \(5, 3\) on cpu, expected shape \(6000, 3\)",
     {"normals": numpy.ones((5, 3))}),
    (ValueError, r"normals is .* of shape \(6000, 2\) on cpu, expected shape",
     {"normals": numpy.ones((6000, 2))}),
])
def test_refusals(cube, error, message, named):
    with pytest.raises(error, match=message) as raised:
        l0_resample_point_set(cube, **named)
    assert_is_in_python_words(str(raised.value))


def test_memory_that_does_not_suffice(cube):
    with pytest.raises(MemoryError, match="maximum_memory"):
        l0_resample_point_set(cube, maximum_memory=1000)


def assert_is_in_python_words(message):
    for word in ("l0_resample_point_set:", "(true)", "(false)", "_map", "std::", "None", "^"):
        assert word not in message, message


@pytest.mark.parametrize("shape", [(3,), (5, 2), (5, 4), (5, 3, 1), (0,)])
def test_shapes_that_are_no_points(shape):
    with pytest.raises(ValueError, match="points is a float64 array of shape .* expected shape"):
        l0_resample_point_set(numpy.zeros(shape))


def test_report(cube, tool):
    report = l0_resample_point_set(cube, report=True)[2]
    _, _, of_the_program = tool(cube)
    assert len(l0_resample_point_set(cube)) == 2
    assert report.number_of_input_points == 6000 and report.number_of_output_points == 3000
    assert (report.device, report.device_reason) == ("cpu", "asked for")
    expected = of_the_program["resampling"]
    for name in ("neighbor_radius", "normal_filter_radius", "oriented_share", "converged"):
        assert getattr(report, name) == expected[name], name
    assert report.number_of_self_neighbor_pairs == expected["self_neighbor_pairs"]
    names = [stage["name"] for stage in expected["stages"]]
    assert [stage.name for stage in report.stages] == names
    for iteration, other in zip(report.iterations, expected["iterations"], strict=True):
        flat = {**dataclasses.asdict(iteration), **dataclasses.asdict(iteration.solver)}
        del flat["solver"]
        flat["solver_iterations"] = flat.pop("iterations")
        assert flat == other
    with pytest.raises(dataclasses.FrozenInstanceError):
        report.converged = False
    assert hash(report) == hash(dataclasses.replace(report))


def test_warnings(cube, tool):
    with pytest.warns(cgal_l0.ResamplingWarning) as issued:
        report = l0_resample_point_set(cube, neighbor_radius=0.0001, report=True)[2]
    assert report.warnings == tuple(str(warning.message) for warning in issued)
    assert any("of the points have fewer than six points" in warning for warning in report.warnings)
    assert all(warning.filename == __file__ for warning in issued)
    _, _, of_the_program = tool(cube, "--neighbor-radius", "0.0001")
    assert report.warnings == tuple(line.split(": ", 1)[1] for line in of_the_program["warnings"])
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert l0_resample_point_set(cube, report=True)[2].warnings == ()


def test_place_that_the_result_does_not_explain(cube, tool):
    random = numpy.random.default_rng(3)
    points = random.uniform(-1, 1, (10000, 3))
    points[:, 2] = numpy.where(points[:, 0] > 0, 0.05, 0.01) * random.normal(size=10000)
    with pytest.warns(cgal_l0.ResamplingWarning, match=r"of the result, as within .* of \(.*\)"):
        report = l0_resample_point_set(points, report=True)[2]
    assert 0 < report.unexplained_radius < 1
    assert 0 < report.unexplained_center[0] < 1 and abs(report.unexplained_center[2]) < 0.2
    _, _, of_the_program = tool(points)
    assert of_the_program["resampling"]["unexplained_place"] == {
        "center": list(report.unexplained_center), "radius": report.unexplained_radius,
        "samples": report.number_of_unexplained_samples_there}
    _, _, of_the_program = tool(cube, "--method", "lor")
    assert of_the_program["resampling"]["unexplained_place"] is None


def test_cuda_is_refused_where_no_device_can_be_seen():
    """In a process of its own, as the device of this one may have been chosen already."""
    program = """if True:
        import cgal_l0, numpy
        points = numpy.random.default_rng(1).random((500, 3))
        try:
            cgal_l0.l0_resample_point_set(points, device="cuda")
        except RuntimeError as error:
            print(error)
        *result, report = cgal_l0.l0_resample_point_set(points, device="auto", report=True)
        print(report.device, len(result[0]), report.device_reason, sep=", ")
    """
    outcome = subprocess.run([sys.executable, "-c", program],
                             env={**os.environ, "CUDA_VISIBLE_DEVICES": "-1"},
                             check=True, capture_output=True, text=True)
    refusal, fallback = outcome.stdout.splitlines()
    reason = refusal.removeprefix("device='cuda': ")
    assert reason != refusal and reason != ""
    assert fallback == f"cpu, 250, {reason}"


def test_cuda_is_refused_or_close(cube):
    *result, report = l0_resample_point_set(cube, device="auto", report=True)
    if report.device == "cuda":
        assert same(result, l0_resample_point_set(cube, device="cuda"))
    else:
        assert report.device_reason not in ("", "asked for")
        assert same(result, l0_resample_point_set(cube))
        with pytest.raises(RuntimeError, match="device='cuda': .*"):
            l0_resample_point_set(cube, device="cuda")
