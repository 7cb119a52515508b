# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Arrays that are not NumPy's. What needs a device is in python_cuda."""

import ctypes

import numpy
import pytest
from cgal_l0 import _core, l0_resample_point_set

without_cuda = False
try:
    l0_resample_point_set(numpy.eye(3), device="cuda")
except RuntimeError as error:
    without_cuda = "built without CUDA" in str(error)


def same(result, other):
    return all(a.dtype == b.dtype and numpy.array_equal(a, b) for a, b in zip(result, other))


class WithArray:
    """As a tensor of torch on the host."""

    def __init__(self, array):
        self.array = array

    def __array__(self, dtype=None, copy=None):
        return self.array if dtype is None else self.array.astype(dtype)


class WithDlpack:
    def __init__(self, array, device=(1, 0)):
        self.array, self.device = array, device
        self.shape, self.dtype = array.shape, array.dtype

    def __dlpack__(self, **options):
        return self.array.__dlpack__()

    def __dlpack_device__(self):
        return self.device


class OnDevice:
    """As an array of Numba: its memory is not looked at before its description is checked."""

    def __init__(self, shape=(9, 3), typestr="<f4", pointer=4096, **more):
        self.shape, self.dtype = shape, numpy.dtype(typestr)
        self.__cuda_array_interface__ = {
            "shape": shape,
            "typestr": typestr,
            "data": (pointer, False),
            "version": 3,
            **more,
        }


def test_arrays_of_the_host(cube):
    expected = l0_resample_point_set(cube)
    for other in (WithArray, WithDlpack):
        assert same(expected, l0_resample_point_set(other(cube))), other
        single = cube.astype(numpy.float32)
        assert same(l0_resample_point_set(single), l0_resample_point_set(other(single))), other
    assert same(expected, l0_resample_point_set(memoryview(cube)))


def test_a_dlpack_array_of_the_host_is_not_copied(cube):
    points = cube.copy()
    from cgal_l0._arrays import coordinates

    (view,) = coordinates(points=WithDlpack(points))
    assert numpy.shares_memory(view, points)


@pytest.mark.parametrize(
    "wrong, error, message",
    [
        (
            numpy.zeros((5, 2), numpy.float32),
            ValueError,
            r"points is a float32 array of shape \(5, 2\) on cpu, expected shape \(n, 3\)",
        ),
        (
            numpy.zeros((5, 3), complex),
            TypeError,
            r"points is a complex128 array of shape \(5, 3\) on cpu, expected numbers",
        ),
        (
            numpy.zeros((5, 4), numpy.float32),
            ValueError,
            r"\(5, 4\) on cpu, expected shape \(n, 3\); points\[:, :3\] has the first three",
        ),
        (
            numpy.zeros(5, [("x", float), ("y", float), ("z", float)]),
            TypeError,
            r"points is an array of records, expected .*structured_to_unstructured\(\) makes one",
        ),
        (
            OnDevice((5, 2)),
            ValueError,
            r"points is a float32 array of shape \(5, 2\) on cuda:0, expected shape \(n, 3\)",
        ),
        (
            OnDevice((15,)),
            ValueError,
            r"points is a float32 array of shape \(15,\) on cuda:0, expected shape \(n, 3\)",
        ),
        (
            OnDevice(typestr="<f2"),
            TypeError,
            r"points is a float16 array of shape \(9, 3\) on cuda:0, expected float32 or float64",
        ),
        (
            OnDevice(typestr="<i8"),
            TypeError,
            r"points is a int64 array of shape \(9, 3\) on cuda:0, expected float32 or float64",
        ),
        (None, TypeError, r"points is None, expected an array of shape \(n, 3\)"),
        (OnDevice(mask=OnDevice()), TypeError, "points is masked"),
        (OnDevice(stream=0), ValueError, "points has the stream 0"),
        (WithDlpack(numpy.zeros((9, 3)), (12, 0)), TypeError, "a device of DLPack type 12"),
    ],
)
def test_errors_name_type_shape_and_device(wrong, error, message):
    with pytest.raises(error, match=message):
        l0_resample_point_set(wrong)


def test_all_arrays_are_on_one_device(cube):
    with pytest.raises(
        ValueError,
        match=r"normals is a float32 array of shape \(9, 3\) on cuda:0, but points is on cpu",
    ):
        l0_resample_point_set(cube, OnDevice())
    with pytest.raises(
        ValueError,
        match=r"orientation_hints is a float64 array of .* on cpu, but points is on cuda:0",
    ):
        l0_resample_point_set(OnDevice(), orientation_hints=cube)
    with pytest.raises(
        ValueError,
        match=r"normals is a float32 array of shape \(8, 3\) on cuda:0, expected shape \(9, 3\)",
    ):
        l0_resample_point_set(OnDevice(), OnDevice((8, 3)))
    with pytest.raises(ValueError, match="points is on cuda:0, which device='cpu' cannot read"):
        l0_resample_point_set(OnDevice(), device="cpu")


@pytest.mark.skipif(not without_cuda, reason="this module was built with CUDA")
@pytest.mark.parametrize("device", [None, "cuda", "auto"])
def test_without_cuda_an_array_of_a_device_is_refused(device):
    with pytest.raises(
        RuntimeError, match="points is on cuda:0, but this module was built without CUDA"
    ):
        l0_resample_point_set(OnDevice(), device=device)


class Tensor(ctypes.Structure):
    """DLManagedTensor of DLPack."""

    _fields_ = [
        ("data", ctypes.c_void_p),
        ("device_type", ctypes.c_int32),
        ("device", ctypes.c_int32),
        ("ndim", ctypes.c_int32),
        ("code", ctypes.c_uint8),
        ("bits", ctypes.c_uint8),
        ("lanes", ctypes.c_uint16),
        ("shape", ctypes.POINTER(ctypes.c_int64)),
        ("strides", ctypes.POINTER(ctypes.c_int64)),
        ("byte_offset", ctypes.c_uint64),
        ("context", ctypes.c_void_p),
        ("deleter", ctypes.c_void_p),
    ]


@pytest.mark.parametrize(
    "code, bits, name",
    [(2, 32, "float32"), (2, 64, "float64"), (4, 16, "bfloat16"), (0, 8, "int8")],
)
def test_dlpack_of_a_device_is_read(code, bits, name):
    shape = (ctypes.c_int64 * 2)(7, 3)
    tensor = Tensor(4096, 2, 1, 2, code, bits, 1, shape, None, 0, None, None)
    new_capsule = ctypes.pythonapi.PyCapsule_New
    new_capsule.restype, new_capsule.argtypes = ctypes.py_object, [
        ctypes.c_void_p,
        ctypes.c_char_p,
        ctypes.c_void_p,
    ]
    streams = []

    class Exporter:
        def __dlpack__(self, *, stream=None):
            streams.append(stream)
            return new_capsule(ctypes.addressof(tensor), b"dltensor", None)

    view = _core.DeviceView.of_dlpack(Exporter())
    assert (view.shape, view.dtype, view.device) == ((7, 3), name, 1)
    assert streams == [1]   # the legacy default stream, after which the call begins

    class Wrong:
        def __dlpack__(self, *, stream=None):
            return new_capsule(ctypes.addressof(tensor), b"used_dltensor", None)

    with pytest.raises(ValueError):
        _core.DeviceView.of_dlpack(Wrong())
