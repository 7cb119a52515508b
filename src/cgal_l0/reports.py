# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""What a call of l0_resample_point_set() did."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True)
class SolverReport:
    """One solve of Eq. (10)."""

    iterations: int
    relative_residual: float
    converged: bool


@dataclass(frozen=True)
class IterationReport:
    """One outer iteration of Algorithm 1; energies in units of the squared radius."""

    penalty: float
    regularized: bool
    fit_energy: float
    regularization_energy: float
    normal_energy: float
    sparsity_energy: float
    active_pair_share: float
    solver: SolverReport


@dataclass(frozen=True)
class StageReport:
    """One stage of a call."""

    name: str
    seconds: float
    peak_bytes: int


@dataclass(frozen=True)
class Report:
    """The members of CGAL::L0_resampling::Report; lengths in the unit of the input, memory in bytes."""

    number_of_input_points: int
    number_of_dropped_points: int
    number_of_outliers: int
    number_of_distinct_points: int
    number_of_output_points: int
    number_of_degenerate_neighborhoods: int
    number_of_lonely_samples: int
    number_of_self_neighbor_pairs: int
    neighbor_radius: float
    normal_filter_radius: float
    estimated_spacing: float
    estimated_noise: float
    oriented_share: float
    hinted_share: float
    iterations: tuple[IterationReport, ...]
    converged: bool
    stages: tuple[StageReport, ...]
    peak_bytes: int
    device: str
    device_reason: str


def report_of(members: dict[str, Any]) -> Report:
    """The report that _core gives as a dictionary."""
    iterations = tuple(IterationReport(**dict(i, solver=SolverReport(**i["solver"]))) for i in members["iterations"])
    stages = tuple(StageReport(**s) for s in members["stages"])
    return Report(**dict(members, iterations=iterations, stages=stages))
