# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

from typing import Any, Callable

from numpy.typing import NDArray

__version__: str

class Method:
    __members__: dict[str, Method]
    default: Method
    lor: Method
    alor: Method
    def __init__(self, value: int) -> None: ...

class Device:
    __members__: dict[str, Device]
    cpu: Device
    cuda: Device
    auto: Device
    def __init__(self, value: int) -> None: ...

expected: dict[str, str]

class Parameters:
    def __init__(self, resampling_method: Method = ...) -> None: ...
    def __setattr__(self, name: str, value: object) -> None: ...

class DeviceArray:
    """An array on a CUDA device, C-contiguous; given back when nobody uses it any more.

    It has __dlpack__ and __cuda_array_interface__, by which torch.from_dlpack(), cupy.asarray()
    and others use its memory without a copy. The numbers are there: nobody has to wait for them.
    """

    @property
    def shape(self) -> tuple[int, ...]: ...
    @property
    def dtype(self) -> str: ...
    @property
    def device(self) -> int: ...
    @property
    def __cuda_array_interface__(self) -> dict[str, Any]: ...
    def __dlpack__(
        self,
        *,
        stream: Any = None,
        max_version: Any = None,
        dl_device: Any = None,
        copy: bool | None = None,
    ) -> Any: ...
    def __dlpack_device__(self) -> tuple[int, int]: ...
    def __len__(self) -> int: ...
    def copy_to_host(self) -> NDArray[Any]: ...

class DeviceView:
    def __init__(
        self,
        owner: object,
        pointer: int,
        shape: tuple[int, ...],
        strides: tuple[int, ...] | None,
        typestr: str,
        stream: int,
    ) -> None: ...
    @staticmethod
    def of_dlpack(array: object) -> DeviceView: ...
    @property
    def shape(self) -> tuple[int, ...]: ...
    @property
    def dtype(self) -> str: ...
    @property
    def device(self) -> int: ...

def device_of_pointer(pointer: int) -> int: ...
def resample(
    points: NDArray[Any],
    normals: NDArray[Any] | None,
    orientation_hints: NDArray[Any] | None,
    viewpoints: NDArray[Any] | None,
    noises: NDArray[Any] | None,
    parameters: Parameters,
    callback: Callable[[float], object] | None,
) -> (
    tuple[
        NDArray[Any],
        NDArray[Any],
        NDArray[Any],
        NDArray[Any],
        NDArray[Any],
        NDArray[Any],
        tuple[list[dict[str, Any]], list[dict[str, Any]]],
        dict[str, Any],
    ]
    | None
): ...
def orient(
    points: NDArray[Any],
    normals: NDArray[Any] | None,
    orientation_hints: NDArray[Any] | None,
    viewpoints: NDArray[Any] | None,
    parameters: Parameters,
    callback: Callable[[float], object] | None,
) -> tuple[NDArray[Any], dict[str, Any]] | None: ...
def resample_on_device(
    points: DeviceView,
    normals: DeviceView | None,
    orientation_hints: DeviceView | None,
    viewpoints: DeviceView | None,
    parameters: Parameters,
    callback: Callable[[float], object] | None,
) -> (
    tuple[
        DeviceArray,
        DeviceArray,
        DeviceArray | None,
        DeviceArray | None,
        DeviceArray | None,
        DeviceArray | None,
        dict[str, Any],
    ]
    | None
): ...
def read_points(
    path: bytes,
    format: str | None,
    columns: str | None,
    decimal_comma: bool,
    drop_non_finite: bool,
    decompression: str,
    callback: Callable[[float], object] | None,
) -> tuple[NDArray[Any], NDArray[Any] | None, list[str], NDArray[Any], int, list[str]] | None: ...
def write_points(
    path: bytes,
    format: str | None,
    points: NDArray[Any],
    normals: NDArray[Any] | None,
    properties: NDArray[Any],
) -> list[str]: ...
def snapshot(
    points: NDArray[Any],
    input_normals: NDArray[Any] | None,
    positions: NDArray[Any],
    normals: NDArray[Any],
    feature_confidences: NDArray[Any] | None,
    colors_of_normals: bool,
    view: list[float] | None,
    up: list[float] | None,
    number_of_views: int,
    path: bytes | None,
) -> NDArray[Any]: ...
