# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

from contextlib import AbstractContextManager
from os import PathLike
from typing import Any, Callable, Literal, Mapping, Sequence, Protocol, TextIO, TypeAlias, overload

from numpy import uint8
from numpy.typing import ArrayLike, NDArray

from ._core import DeviceArray as DeviceArray
from ._files import PointCloud as PointCloud
from ._resampling import Cancelled as Cancelled
from .creases import Corner as Corner
from .creases import Crease as Crease
from .creases import Creases as Creases
from .reports import IterationReport as IterationReport
from .reports import Report as Report
from .reports import SolverReport as SolverReport
from .reports import StageReport as StageReport

__version__: str
__all__ = [
    "l0_orient_normals",
    "l0_resample_point_set",
    "progress_bar",
    "read_points",
    "snapshot",
    "write_points",
]

class _OnDevice(Protocol):
    def __dlpack__(self, *, stream: Any = None) -> Any: ...
    def __dlpack_device__(self) -> tuple[Any, int]: ...

class ResamplingWarning(UserWarning): ...

class _OnCudaDevice(Protocol):
    @property
    def __cuda_array_interface__(self) -> Any: ...

_Points: TypeAlias = ArrayLike | _OnDevice | _OnCudaDevice
# float32 or float64, as the points. For points on a CUDA device, which their type does not tell, it
# is a DeviceArray.
_Array: TypeAlias = NDArray[Any]
_Path: TypeAlias = str | PathLike[str]

@overload
def l0_resample_point_set(
    points: _Points,
    normals: _Points | None = None,
    *,
    number_of_output_points: int | None = None,
    select_percentage: float = 50,
    method: Literal["default", "lor", "alor"] = "default",
    neighbor_radius: float | None = None,
    noise: float | ArrayLike | None = None,
    normal_filter_radius: float | None = None,
    sharpness_angle: float = 15,
    number_of_normal_filter_iterations: int = 3,
    normal_weight: float = 0.9,
    regularization_weight: float = 0.15,
    initial_penalty: float = 0.1,
    maximum_penalty: float = 2,
    penalty_growth: float | None = None,
    keep_density: bool = False,
    viewpoint: Sequence[float] | None = None,
    viewpoints: _Points | None = None,
    up_direction: Sequence[float] | None = None,
    orientation_hints: _Points | None = None,
    number_of_orientation_neighbors: int = 12,
    random_seed: int = 0,
    drop_non_finite: bool = False,
    drop_outliers: bool | None = None,
    outlier_sensitivity: float | None = None,
    maximum_memory: int | None = None,
    threads: int | None = None,
    device: Literal["cpu", "cuda", "auto"] | None = None,
    callback: Callable[[float], object] | None = None,
    source_indices: Literal[False] = False,
    feature_confidences: Literal[False] = False,
    side_confidences: Literal[False] = False,
    neighbor_radii: Literal[False] = False,
    noises: Literal[False] = False,
    position_deviations: Literal[False] = False,
    normal_deviations: Literal[False] = False,
    creases: Literal[False] = False,
    outliers: Literal[False] = False,
    report: Literal[False] = False,
) -> tuple[_Array, _Array]: ...
@overload
def l0_resample_point_set(
    points: _Points,
    normals: _Points | None = None,
    *,
    number_of_output_points: int | None = None,
    select_percentage: float = 50,
    method: Literal["default", "lor", "alor"] = "default",
    neighbor_radius: float | None = None,
    noise: float | ArrayLike | None = None,
    normal_filter_radius: float | None = None,
    sharpness_angle: float = 15,
    number_of_normal_filter_iterations: int = 3,
    normal_weight: float = 0.9,
    regularization_weight: float = 0.15,
    initial_penalty: float = 0.1,
    maximum_penalty: float = 2,
    penalty_growth: float | None = None,
    keep_density: bool = False,
    viewpoint: Sequence[float] | None = None,
    viewpoints: _Points | None = None,
    up_direction: Sequence[float] | None = None,
    orientation_hints: _Points | None = None,
    number_of_orientation_neighbors: int = 12,
    random_seed: int = 0,
    drop_non_finite: bool = False,
    drop_outliers: bool | None = None,
    outlier_sensitivity: float | None = None,
    maximum_memory: int | None = None,
    threads: int | None = None,
    device: Literal["cpu", "cuda", "auto"] | None = None,
    callback: Callable[[float], object] | None = None,
    source_indices: Literal[False] = False,
    feature_confidences: Literal[False] = False,
    side_confidences: Literal[False] = False,
    neighbor_radii: Literal[False] = False,
    noises: Literal[False] = False,
    position_deviations: Literal[False] = False,
    normal_deviations: Literal[False] = False,
    creases: Literal[False] = False,
    outliers: Literal[False] = False,
    report: Literal[True],
) -> tuple[_Array, _Array, Report]: ...
@overload
def l0_resample_point_set(
    points: _Points,
    normals: _Points | None = None,
    *,
    number_of_output_points: int | None = None,
    select_percentage: float = 50,
    method: Literal["default", "lor", "alor"] = "default",
    neighbor_radius: float | None = None,
    noise: float | ArrayLike | None = None,
    normal_filter_radius: float | None = None,
    sharpness_angle: float = 15,
    number_of_normal_filter_iterations: int = 3,
    normal_weight: float = 0.9,
    regularization_weight: float = 0.15,
    initial_penalty: float = 0.1,
    maximum_penalty: float = 2,
    penalty_growth: float | None = None,
    keep_density: bool = False,
    viewpoint: Sequence[float] | None = None,
    viewpoints: _Points | None = None,
    up_direction: Sequence[float] | None = None,
    orientation_hints: _Points | None = None,
    number_of_orientation_neighbors: int = 12,
    random_seed: int = 0,
    drop_non_finite: bool = False,
    drop_outliers: bool | None = None,
    outlier_sensitivity: float | None = None,
    maximum_memory: int | None = None,
    threads: int | None = None,
    device: Literal["cpu", "cuda", "auto"] | None = None,
    callback: Callable[[float], object] | None = None,
    source_indices: bool = False,
    feature_confidences: bool = False,
    side_confidences: bool = False,
    neighbor_radii: bool = False,
    noises: bool = False,
    position_deviations: bool = False,
    normal_deviations: bool = False,
    creases: bool = False,
    outliers: bool = False,
    report: bool = False,
) -> tuple[Any, ...]: ...
@overload
def l0_orient_normals(
    points: ArrayLike,
    normals: ArrayLike | None = None,
    *,
    neighbor_radius: float | None = None,
    viewpoint: Sequence[float] | None = None,
    viewpoints: ArrayLike | None = None,
    up_direction: Sequence[float] | None = None,
    orientation_hints: ArrayLike | None = None,
    number_of_orientation_neighbors: int = 12,
    drop_non_finite: bool = False,
    maximum_memory: int | None = None,
    threads: int | None = None,
    device: Literal["cpu", "cuda", "auto"] = "cpu",
    callback: Callable[[float], object] | None = None,
    report: Literal[False] = False,
) -> NDArray[Any]: ...
@overload
def l0_orient_normals(
    points: ArrayLike,
    normals: ArrayLike | None = None,
    *,
    neighbor_radius: float | None = None,
    viewpoint: Sequence[float] | None = None,
    viewpoints: ArrayLike | None = None,
    up_direction: Sequence[float] | None = None,
    orientation_hints: ArrayLike | None = None,
    number_of_orientation_neighbors: int = 12,
    drop_non_finite: bool = False,
    maximum_memory: int | None = None,
    threads: int | None = None,
    device: Literal["cpu", "cuda", "auto"] = "cpu",
    callback: Callable[[float], object] | None = None,
    report: Literal[True],
) -> tuple[NDArray[Any], Report]: ...
def read_points(
    path: _Path,
    *,
    format: str | None = None,
    columns: str | Sequence[str] | None = None,
    decimal_comma: bool = False,
    drop_non_finite: bool = False,
    decompress: str | None = None,
    callback: Callable[[float], object] | None = None,
) -> PointCloud: ...
def write_points(
    path: _Path,
    points: ArrayLike,
    normals: ArrayLike | None = None,
    properties: Mapping[str, ArrayLike] | None = None,
    *,
    format: str | None = None,
) -> None: ...
def snapshot(
    points: ArrayLike,
    positions: ArrayLike,
    normals: ArrayLike,
    *,
    input_normals: ArrayLike | None = None,
    feature_confidences: ArrayLike | None = None,
    colors: str = "shaded",
    view: Sequence[float] | None = None,
    up: Sequence[float] | None = None,
    views: int = 1,
    path: _Path | None = None,
) -> NDArray[uint8]: ...
def progress_bar(
    description: str = "resampling", *, file: TextIO | None = None
) -> AbstractContextManager[Callable[[float], None]]: ...
