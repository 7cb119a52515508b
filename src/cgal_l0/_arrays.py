# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Arrays of the caller, on the host and on CUDA devices."""

import numpy

from . import _core

_cpu, _cuda, _cuda_managed = 1, 2, 13   # device types of DLPack


def _dlpack_device(array):
    """The type and the number of the device that an array says it is on, or None."""
    method = getattr(array, "__dlpack_device__", None)
    return None if method is None else tuple(map(int, method()))


def cuda_device_of(array):
    """The number of the CUDA device that an array is on, or None for memory of the host."""
    device = _dlpack_device(array)
    if device is not None:
        return device[1] if device[0] in (_cuda, _cuda_managed) else None
    interface = getattr(array, "__cuda_array_interface__", None)
    return None if interface is None else _core.device_of_pointer(interface["data"][0])


def _number_type(array):
    dtype = getattr(array, "dtype", None)
    return "" if dtype is None else str(dtype).replace("torch.", "") + " "


def _described(name, array, device):
    """Such as "normals is a float32 array of shape (5, 2) on cpu"."""
    shape = tuple(getattr(array, "shape", ()))
    return f"{name} is a {_number_type(array)}array of shape {shape} on {device}"


def _place(device):
    return "cpu" if device is None else f"cuda:{device}"


def _checked_shape(name, array, device, size):
    shape = tuple(array.shape)
    if len(shape) != 2 or shape[1] != 3:
        has_more = len(shape) == 2 and shape[1] > 3
        hint = f"; {name}[:, :3] has the first three columns" if has_more else ""
        raise ValueError(f"{_described(name, array, _place(device))}, expected shape (n, 3){hint}")
    if size is not None and shape[0] != size:
        raise ValueError(
            f"{_described(name, array, _place(device))}, expected shape ({size}, 3) as points"
        )


def _host_array(name, numbers):
    """The numbers as an array of float32 or float64: the same memory if they are one already."""
    if hasattr(numbers, "__dlpack__") and not hasattr(numbers, "__array__"):
        device = _dlpack_device(numbers)
        if device[0] != _cpu:
            raise TypeError(
                f"{_described(name, numbers, f'a device of DLPack type {device[0]}')}, "
                "expected memory of the host or of a CUDA device"
            )
        numbers = numpy.from_dlpack(numbers)
    array = numpy.asarray(numbers)
    is_number = array.dtype.kind in "fiub"
    kind = numpy.result_type(array.dtype, numpy.float32) if is_number else array.dtype
    if array.dtype.names:
        raise TypeError(
            f"{name} is an array of records, expected one of shape (n, 3): "
            "numpy.lib.recfunctions.structured_to_unstructured() makes one of three of its fields"
        )
    if kind not in (numpy.float32, numpy.float64):
        raise TypeError(f"{_described(name, array, 'cpu')}, expected numbers that float64 can hold")
    return array.astype(kind, copy=False)


def _device_array(name, array):
    """A view of an array of float32 or float64 on a CUDA device."""
    if _dlpack_device(array) is not None:
        view = _core.DeviceView.of_dlpack(array)
    else:
        interface = array.__cuda_array_interface__
        if interface.get("mask") is not None:
            raise TypeError(
                f"{name} is masked by its __cuda_array_interface__, expected an array without mask"
            )
        stream = interface.get("stream")
        if stream == 0:
            raise ValueError(
                f"{name} has the stream 0, which __cuda_array_interface__ does not allow"
            )
        view = _core.DeviceView(
            array,
            interface["data"][0],
            interface["shape"],
            interface.get("strides"),
            interface["typestr"],
            -1 if stream is None else stream,
        )
    if view.dtype not in ("float32", "float64"):
        raise TypeError(
            f"{_described(name, view, _place(view.device))}, expected float32 or float64"
        )
    return view


def is_array(value):
    """Whether a parameter is one number for each point, and not one for all, or None."""
    is_sequence = hasattr(value, "__len__") and not isinstance(value, str)
    return is_sequence and getattr(value, "ndim", 1) > 0


def numbers_of_points(name, numbers, points):
    """One number for each point, as the column that _core takes.

    Raises TypeError or ValueError that name the array, with its number type, shape and device.
    """
    array = _host_array(name, numbers)
    if array.shape != (len(points),):
        raise ValueError(
            f"{_described(name, array, 'cpu')}, expected shape ({len(points)},), a number for each "
            "point"
        )
    return array[:, None]


def coordinates(**arrays):
    """The arrays, of which the first is that of the points, in the form that _core takes.

    Raises TypeError or ValueError that name the array, with its number type, shape and device.
    """
    (first, points), *_ = arrays.items()
    if points is None:
        raise TypeError(f"{first} is None, expected an array of shape (n, 3)")
    device = cuda_device_of(points)
    answer, size = [], None
    for name, array in arrays.items():
        if array is None:
            answer.append(None)
            continue
        own_device = cuda_device_of(array)
        if own_device != device:
            raise ValueError(
                f"{_described(name, array, _place(own_device))}, but {first} is on "
                f"{_place(device)}: "
                "expected one device"
            )
        converted = _host_array(name, array) if device is None else _device_array(name, array)
        _checked_shape(name, converted, device, size)
        size = converted.shape[0]
        answer.append(converted)
    return answer
