# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Points on a CUDA device are resampled there: arrays of torch, CuPy, and of nobody's library.

Without a device, or with a module that was built without CUDA, all of this is skipped; without
torch or CuPy what needs them is.
"""

import ctypes
import gc

import cgal_l0
import numpy
import pytest
from cgal_l0 import l0_resample_point_set

try:
    l0_resample_point_set(numpy.eye(3), device="cuda")
except RuntimeError as reason:
    pytest.skip(str(reason), allow_module_level=True)


def optional(name):
    try:
        return __import__(name)
    except ImportError:
        return None


torch, cupy = optional("torch"), optional("cupy")
needs_torch = pytest.mark.skipif(
    torch is None or not torch.cuda.is_available(), reason="no torch with CUDA"
)
needs_cupy = pytest.mark.skipif(cupy is None, reason="no CuPy")


def noisy_cube(n, number_type, seed=1):
    random = numpy.random.default_rng(seed)
    points = random.uniform(-0.5, 0.5, size=(n, 3))
    axis = random.integers(3, size=n)
    normals = numpy.zeros((n, 3))
    normals[numpy.arange(n), axis] = random.choice([-1.0, 1.0], size=n)
    points[numpy.arange(n), axis] = normals[numpy.arange(n), axis] / 2
    return (points + random.normal(scale=0.01, size=(n, 3))).astype(number_type), normals.astype(
        number_type
    )


@pytest.fixture(params=[numpy.float32, numpy.float64])
def cube(request):
    return noisy_cube(20000, request.param)


def driver():
    library = ctypes.CDLL("libcuda.so.1")
    library.cuInit(0)
    return library


class DriverArray:
    """Memory that the driver gives, with __cuda_array_interface__ and any strides."""

    def __init__(self, array):
        self.library, self.shape, self.dtype = driver(), array.shape, array.dtype
        device, context = ctypes.c_int(), ctypes.c_void_p()
        assert self.library.cuDeviceGet(ctypes.byref(device), 0) == 0
        assert self.library.cuDevicePrimaryCtxRetain(ctypes.byref(context), device) == 0
        assert self.library.cuCtxSetCurrent(context) == 0
        base = array if array.base is None else array.base
        self.pointer = ctypes.c_uint64()
        assert (
            self.library.cuMemAlloc_v2(ctypes.byref(self.pointer), ctypes.c_size_t(base.nbytes))
            == 0
        )
        assert (
            self.library.cuMemcpyHtoD_v2(
                self.pointer, base.ctypes.data_as(ctypes.c_void_p), ctypes.c_size_t(base.nbytes)
            )
            == 0
        )
        offset = array.ctypes.data - base.ctypes.data
        self.__cuda_array_interface__ = {
            "shape": array.shape,
            "typestr": array.dtype.str,
            "version": 3,
            "strides": array.strides,
            "data": (self.pointer.value + offset, False),
        }

    def __del__(self):
        self.library.cuMemFree_v2(self.pointer)


def host(array):
    return array.copy_to_host()


def same(result, other):
    return all(a.dtype == b.dtype and numpy.array_equal(a, b) for a, b in zip(result, other))


def test_equals_the_call_from_the_host(cube):
    points, normals = cube
    expected = l0_resample_point_set(points, device="cuda")
    *result, report = l0_resample_point_set(DriverArray(points), report=True)
    assert [type(array) for array in result] == [cgal_l0.DeviceArray] * 2
    assert (report.device, report.device_reason) == ("cuda", "the points are on it")
    assert report.number_of_input_points == len(points) and report.number_of_output_points == len(
        result[0]
    )
    assert same(map(host, result), expected)
    assert (
        result[0].shape == (10000, 3)
        and result[0].dtype == str(points.dtype)
        and len(result[0]) == 10000
    )
    assert "float" in repr(result[0]) and "cuda:0" in repr(result[0])
    for device in ("cuda", "auto"):
        assert same(map(host, l0_resample_point_set(DriverArray(points), device=device)), expected)


def test_normals_hints_and_parameters(cube):
    points, normals = cube
    scaled = normals * numpy.linspace(-3, 2, len(normals), dtype=points.dtype)[:, None]
    scaled[::7] = 0
    scaled[3] = numpy.nan
    expected = l0_resample_point_set(points, scaled, device="cuda")
    result = list(map(host, l0_resample_point_set(DriverArray(points), DriverArray(scaled))))
    # The last bit of a normal may differ, as the device contracts a product and a sum.
    assert numpy.abs(result[0] - expected[0]).max() < 1e-6
    outward = (
        numpy.copysign(1, (points * normals).sum(axis=1, keepdims=True)).astype(points.dtype)
        * normals
    )
    for sign in (1, -1):
        hints = sign * outward
        *hinted, report = l0_resample_point_set(
            DriverArray(points), orientation_hints=DriverArray(hints), report=True
        )
        assert report.hinted_share == 1
        assert same(
            map(host, hinted), l0_resample_point_set(points, orientation_hints=hints, device="cuda")
        )
    *facing, report = l0_resample_point_set(
        DriverArray(points), viewpoints=DriverArray(points - outward), report=True
    )
    assert report.hinted_share == 1
    hosted = l0_resample_point_set(points, viewpoints=points - outward, device="cuda")
    # The directions may differ in the last bit.
    assert numpy.abs(host(facing[0]) - hosted[0]).max() < 1e-6
    assert (host(facing[1]) * hosted[1]).sum(axis=1).min() > 0.99
    options = {
        "number_of_output_points": 777,
        "method": "lor",
        "random_seed": 5,
        "neighbor_radius": 0.2,
    }
    assert same(
        map(host, l0_resample_point_set(DriverArray(points), **options)),
        l0_resample_point_set(points, device="cuda", **options),
    )
    with pytest.raises(ValueError, match="viewpoint is given, expected no orientation_hints"):
        l0_resample_point_set(
            DriverArray(points), orientation_hints=DriverArray(outward), viewpoint=(0, 0, 0)
        )
    with pytest.raises(ValueError, match="normal_weight is -1"):
        l0_resample_point_set(DriverArray(points), normal_weight=-1)
    with pytest.raises(MemoryError):
        l0_resample_point_set(DriverArray(points), maximum_memory=1000)


@pytest.mark.parametrize(
    "view",
    [
        lambda a: numpy.asfortranarray(a),
        lambda a: numpy.repeat(a, 2, axis=0)[::2],
        lambda a: numpy.hstack([a, a])[:, 1:4][:, ::-1],
        lambda a: numpy.array(a[::-1])[::-1],
    ],
)
def test_any_strides(cube, view):
    points = view(cube[0])
    expected = l0_resample_point_set(numpy.ascontiguousarray(points), device="cuda")
    array = DriverArray(points)
    assert same(map(host, l0_resample_point_set(array)), expected)


def test_points_that_are_not_finite(cube):
    points = cube[0]
    bad = numpy.insert(points, [5, 700], numpy.nan, axis=0)
    bad[5, :2] = 1, 2
    with pytest.raises(
        ValueError, match=r"points\[5\] has a coordinate that is not finite \(1.0*, 2.0*, nan\)"
    ):
        l0_resample_point_set(DriverArray(bad))
    *result, report = l0_resample_point_set(DriverArray(bad), drop_non_finite=True, report=True)
    assert report.number_of_dropped_points == 2
    assert same(map(host, result), l0_resample_point_set(points, device="cuda"))
    *nothing, report = l0_resample_point_set(
        DriverArray(bad[5:6]), drop_non_finite=True, report=True
    )
    assert report.number_of_dropped_points == 1 and nothing[0].shape == nothing[1].shape == (0, 3)


def test_further_results(cube):
    points = cube[0]
    bad = numpy.insert(points, 5, numpy.nan, axis=0)
    for source in (points, bad):
        options = {"source_indices": True, "feature_confidences": True, "neighbor_radii": True,
                   "noises": True, "position_deviations": True, "normal_deviations": True,
                   "drop_non_finite": True}
        result = list(map(host, l0_resample_point_set(DriverArray(source), **options)))
        assert same(result, l0_resample_point_set(source, device="cuda", **options))
        assert result[2].dtype == numpy.int64 and result[2].shape == (10000,)


def test_coincident_results_are_separated():
    """At this offset float32 has too few places for as many points."""
    points = (noisy_cube(20000, numpy.float64)[0] + 4e5).astype(numpy.float32)
    options = {"number_of_output_points": 4000}
    positions = host(l0_resample_point_set(DriverArray(points), **options)[0])
    expected = l0_resample_point_set(points, device="cuda", **options)[0]
    assert numpy.array_equal(positions, expected)
    assert len(numpy.unique(positions, axis=0)) == 4000


def test_denormal_numbers():
    points = (noisy_cube(5000, numpy.float64)[0] * 2.0**-140).astype(numpy.float32)
    assert same(
        map(host, l0_resample_point_set(DriverArray(points))),
        l0_resample_point_set(points, device="cuda"),
    )


class Empty:
    shape, dtype = (0, 3), numpy.dtype(numpy.float32)
    __cuda_array_interface__ = {"shape": (0, 3), "typestr": "<f4", "data": (0, False), "version": 3}


def test_small_sets():
    assert [array.shape for array in l0_resample_point_set(Empty())] == [(0, 3), (0, 3)]
    for n in (1, 2, 3, 33):
        points = noisy_cube(n, numpy.float32)[0]
        assert same(
            map(host, l0_resample_point_set(DriverArray(points))),
            l0_resample_point_set(points, device="cuda"),
        )


def test_cancellation(cube):
    with pytest.raises(cgal_l0.Cancelled):
        l0_resample_point_set(DriverArray(cube[0]), callback=lambda share: False)


def test_memory_is_given_back(cube):
    library, array = driver(), DriverArray(cube[0])

    def free():
        amount, total = ctypes.c_size_t(), ctypes.c_size_t()
        assert library.cuMemGetInfo_v2(ctypes.byref(amount), ctypes.byref(total)) == 0
        return amount.value

    l0_resample_point_set(array)
    gc.collect()
    before = free()
    for _ in range(20):
        result = l0_resample_point_set(array, number_of_output_points=200_000)
        result[0].__dlpack__()   # which nobody takes
        result[1].__cuda_array_interface__
    del result
    gc.collect()
    assert before - free() < 2 << 20


def test_the_result_goes_in_again(cube):
    positions, normals = l0_resample_point_set(DriverArray(cube[0]))
    again = l0_resample_point_set(positions, normals)
    expected = l0_resample_point_set(host(positions), host(normals), device="cuda")
    assert numpy.abs(host(again[0]) - expected[0]).max() < 1e-6


def test_exports(cube):
    positions, _ = l0_resample_point_set(DriverArray(cube[0]))
    interface = positions.__cuda_array_interface__
    assert (
        interface["shape"] == (10000, 3)
        and interface["version"] == 3
        and interface["stream"] is None
    )
    assert (
        interface["typestr"] == cube[0].dtype.str
        and interface["strides"] is None
        and interface["data"][0] > 0
    )
    assert positions.__dlpack_device__() == (2, 0)
    assert (
        positions.__dlpack__(stream=1, max_version=(1, 0), dl_device=(2, 0), copy=False) is not None
    )
    for options in ({"dl_device": (1, 0)}, {"copy": True}):
        with pytest.raises(BufferError):
            positions.__dlpack__(**options)


@needs_torch
def test_torch(cube):
    points = torch.from_numpy(cube[0]).cuda()
    kept = points.clone()
    expected = l0_resample_point_set(cube[0], device="cuda")
    positions, normals = map(torch.from_dlpack, l0_resample_point_set(points))
    assert positions.is_cuda and positions.dtype == points.dtype
    assert same((positions.cpu().numpy(), normals.cpu().numpy()), expected)
    assert torch.equal(points, kept)
    transposed = points.t().contiguous().t()
    assert torch.equal(torch.from_dlpack(l0_resample_point_set(transposed)[0]), positions)
    gc.collect()
    assert torch.isfinite(positions).all()   # it lives on by itself
    with pytest.raises(
        TypeError,
        match="points is a float16 array of shape .* on cuda:0, expected float32 or float64",
    ):
        l0_resample_point_set(points.half())
    with pytest.raises(
        ValueError,
        match=r"normals is a float\d\d array of shape .* on cpu, but points is on cuda:0",
    ):
        l0_resample_point_set(points, points.cpu())


@needs_torch
def test_streams_of_torch(cube):
    """The points are there only after much work of another stream; before, there are zeros."""
    source = torch.from_numpy(cube[0]).cuda()
    expected = torch.from_dlpack(l0_resample_point_set(source)[0])
    stream = torch.cuda.Stream()
    torch.cuda.synchronize()
    for interface in ("dlpack", "cuda_array_interface"):
        with torch.cuda.stream(stream):
            points = torch.zeros_like(source)
            torch.cuda._sleep(int(1e9))
            points.copy_(source)
            array = points if interface == "dlpack" else WithStream(points, stream.cuda_stream)
            result = torch.from_dlpack(l0_resample_point_set(array)[0])
        assert torch.equal(result, expected), interface


class WithStream:
    def __init__(self, tensor, stream):
        self.tensor = tensor
        self.shape, self.dtype = tuple(tensor.shape), tensor.dtype
        self.__cuda_array_interface__ = dict(
            tensor.__cuda_array_interface__, stream=stream, version=3
        )


@needs_cupy
def test_cupy(cube):
    points = cupy.asarray(cube[0])
    expected = l0_resample_point_set(cube[0], device="cuda")
    result = l0_resample_point_set(points)
    for take in (cupy.asarray, cupy.from_dlpack):
        positions, normals = map(take, result)
        assert positions.data.ptr == result[0].__cuda_array_interface__["data"][0]   # no copy
        assert same((positions.get(), normals.get()), expected)
    with cupy.cuda.Stream(non_blocking=True):
        shifted = cupy.asarray(cube[0]) + points.dtype.type(1)
        later = cupy.asarray(l0_resample_point_set(shifted)[0])
    expected = l0_resample_point_set(cube[0] + cube[0].dtype.type(1), device="cuda")
    assert same((later.get(),), expected[:1])
