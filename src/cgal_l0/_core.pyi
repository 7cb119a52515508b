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

class Parameters:
    resampling_method: Method
    number_of_output_points: int | None
    select_percentage: float
    neighbor_radius: float | None
    normal_filter_radius: float | None
    sharpness_angle: float
    number_of_normal_filter_iterations: int
    normal_weight: float
    regularization_weight: float
    initial_penalty: float
    maximum_penalty: float
    penalty_growth: float | None
    keep_density: bool
    viewpoint: list[float] | None
    source_indices: bool
    feature_confidences: bool
    number_of_orientation_neighbors: int
    random_seed: int
    drop_non_finite: bool
    drop_outliers: bool | None
    maximum_memory: int
    threads: int | None
    device: Device
    def __init__(self, resampling_method: Method = ...) -> None: ...

def resample(
    points: NDArray[Any],
    normals: NDArray[Any] | None,
    orientation_hints: NDArray[Any] | None,
    parameters: Parameters,
    callback: Callable[[float], object] | None,
) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any], NDArray[Any], dict[str, Any]] | None: ...
