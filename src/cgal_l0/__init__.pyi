# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

from typing import Any, Callable, Literal, Sequence, overload

from numpy.typing import ArrayLike, NDArray

from .reports import IterationReport as IterationReport
from .reports import Report as Report
from .reports import SolverReport as SolverReport
from .reports import StageReport as StageReport

__version__: str
__all__ = ["Cancelled", "IterationReport", "Report", "SolverReport", "StageReport", "l0_resample_point_set"]

class Cancelled(Exception): ...

# float32 or float64, as the points
_Array = NDArray[Any]

@overload
def l0_resample_point_set(
    points: ArrayLike,
    normals: ArrayLike | None = None,
    *,
    number_of_output_points: int | None = None,
    select_percentage: float = 50,
    method: Literal["default", "lor", "alor"] = "default",
    neighbor_radius: float | None = None,
    normal_filter_radius: float | None = None,
    sharpness_angle: float = 15,
    number_of_normal_filter_iterations: int = 5,
    normal_weight: float = 0.9,
    regularization_weight: float = 0.15,
    initial_penalty: float = 0.1,
    maximum_penalty: float = 2,
    penalty_growth: float | None = None,
    keep_density: bool = False,
    viewpoint: Sequence[float] | None = None,
    orientation_hints: ArrayLike | None = None,
    number_of_orientation_neighbors: int = 12,
    random_seed: int = 0,
    drop_non_finite: bool = False,
    drop_outliers: bool | None = None,
    maximum_memory: int | None = None,
    threads: int | None = None,
    device: Literal["cpu", "cuda", "auto"] = "cpu",
    callback: Callable[[float], object] | None = None,
    source_indices: Literal[False] = False,
    feature_confidences: Literal[False] = False,
    report: Literal[False] = False,
) -> tuple[_Array, _Array]: ...
@overload
def l0_resample_point_set(
    points: ArrayLike,
    normals: ArrayLike | None = None,
    *,
    number_of_output_points: int | None = None,
    select_percentage: float = 50,
    method: Literal["default", "lor", "alor"] = "default",
    neighbor_radius: float | None = None,
    normal_filter_radius: float | None = None,
    sharpness_angle: float = 15,
    number_of_normal_filter_iterations: int = 5,
    normal_weight: float = 0.9,
    regularization_weight: float = 0.15,
    initial_penalty: float = 0.1,
    maximum_penalty: float = 2,
    penalty_growth: float | None = None,
    keep_density: bool = False,
    viewpoint: Sequence[float] | None = None,
    orientation_hints: ArrayLike | None = None,
    number_of_orientation_neighbors: int = 12,
    random_seed: int = 0,
    drop_non_finite: bool = False,
    drop_outliers: bool | None = None,
    maximum_memory: int | None = None,
    threads: int | None = None,
    device: Literal["cpu", "cuda", "auto"] = "cpu",
    callback: Callable[[float], object] | None = None,
    source_indices: Literal[False] = False,
    feature_confidences: Literal[False] = False,
    report: Literal[True],
) -> tuple[_Array, _Array, Report]: ...
@overload
def l0_resample_point_set(
    points: ArrayLike,
    normals: ArrayLike | None = None,
    *,
    number_of_output_points: int | None = None,
    select_percentage: float = 50,
    method: Literal["default", "lor", "alor"] = "default",
    neighbor_radius: float | None = None,
    normal_filter_radius: float | None = None,
    sharpness_angle: float = 15,
    number_of_normal_filter_iterations: int = 5,
    normal_weight: float = 0.9,
    regularization_weight: float = 0.15,
    initial_penalty: float = 0.1,
    maximum_penalty: float = 2,
    penalty_growth: float | None = None,
    keep_density: bool = False,
    viewpoint: Sequence[float] | None = None,
    orientation_hints: ArrayLike | None = None,
    number_of_orientation_neighbors: int = 12,
    random_seed: int = 0,
    drop_non_finite: bool = False,
    drop_outliers: bool | None = None,
    maximum_memory: int | None = None,
    threads: int | None = None,
    device: Literal["cpu", "cuda", "auto"] = "cpu",
    callback: Callable[[float], object] | None = None,
    source_indices: bool = False,
    feature_confidences: bool = False,
    report: bool = False,
) -> tuple[Any, ...]: ...
