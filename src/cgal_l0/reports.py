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
    """One solve of a linear system.

    iterations: int, of the solver
    relative_residual: float, the last one, relative to the right-hand side
    converged: bool, whether it is below the solver's tolerance
    """

    iterations: int
    relative_residual: float
    converged: bool


@dataclass(frozen=True)
class IterationReport:
    """One iteration of the minimization. Energies have the unit of the squared radius.

    penalty: float, the penalty of this iteration
    regularized: bool, False in the iterations of method="alor" that leave that term out
    fit_energy, regularization_energy, normal_energy, sparsity_energy: floats, the terms of the
        energy at the begin of the iteration
    active_pair_share: float in [0, 1], the share of neighbors that are taken for a jump
    solver: SolverReport
    """

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
    """One stage of a call.

    name: str, such as "filter normals"
    seconds: float, elapsed time
    peak_bytes: int, the most memory that the call's own arrays held during the stage
    """

    name: str
    seconds: float
    peak_bytes: int


@dataclass(frozen=True)
class Report:
    """What a call of l0_resample_point_set() did. Lengths have the unit of the points.

    number_of_input_points: int, the points used, without those that drop_non_finite left out
    number_of_dropped_points: int, those that drop_non_finite left out
    number_of_outliers: int, those that drop_outliers left out
    number_of_distinct_points: int, of the points used, without outliers
    number_of_output_points: int, the points of the result
    number_of_degenerate_neighborhoods: int, points around which there is no plane
    number_of_lonely_samples: int, samples without a point in their radius; they do not move
    number_of_unexplained_samples: int, samples whose points scatter more than those of one surface
        with the estimated noise do
    unexplained_center: tuple of three floats, the one of them that has most of the others within
        unexplained_radius
    unexplained_radius: float, 0 if there are none
    number_of_unexplained_samples_there: int, those within that radius
    number_of_self_neighbor_pairs: int, pairs of samples in the energy
    neighbor_radius, normal_filter_radius: floats, the radii that were used
    least_neighbor_radius, median_neighbor_radius, largest_neighbor_radius: floats, of the radii
        around the points, which differ where "default" follows a spacing or noise that varies
    estimated_spacing: float, the distance between neighboring points; 0 but for "default"
    estimated_noise: float, the standard deviation across the surface, or the noise that was
        given; 0 but for "default"
    sample_spacing: float, the distance between neighboring points of the result; 0 but for
        "default", and 0 with keep_density
    oriented_share: float in [0, 1], the share of samples to which one sign was propagated
    right_side_share: float in [0, 1], the share of normals that can be expected on the right
        side; about 0.5 says that the side is a guess
    hinted_share: float in [0, 1], the share in parts whose side viewpoint, viewpoints,
        up_direction or orientation_hints decided
    extent_share: float in [0, 1], the diagonal of the box of the result per that of the points,
        whose outermost ones and noise do not count
    warnings: tuple of str, why the result cannot be good, a line for each reason
    iterations: tuple of IterationReport
    converged: bool, whether every linear system was solved to its tolerance
    stages: tuple of StageReport, in the order in which they ran
    peak_bytes: int, the most memory that the call's own arrays held, without input and result
    device: str, "cpu" or "cuda"
    device_reason: str, why that device was used
    """

    number_of_input_points: int
    number_of_dropped_points: int
    number_of_outliers: int
    number_of_distinct_points: int
    number_of_output_points: int
    number_of_degenerate_neighborhoods: int
    number_of_lonely_samples: int
    number_of_unexplained_samples: int
    unexplained_center: tuple[float, float, float]
    unexplained_radius: float
    number_of_unexplained_samples_there: int
    number_of_self_neighbor_pairs: int
    neighbor_radius: float
    least_neighbor_radius: float
    median_neighbor_radius: float
    largest_neighbor_radius: float
    normal_filter_radius: float
    estimated_spacing: float
    estimated_noise: float
    sample_spacing: float
    oriented_share: float
    right_side_share: float
    hinted_share: float
    extent_share: float
    warnings: tuple[str, ...]
    iterations: tuple[IterationReport, ...]
    converged: bool
    stages: tuple[StageReport, ...]
    peak_bytes: int
    device: str
    device_reason: str


def report_of(members: dict[str, Any]) -> Report:
    """The report that _core gives as a dictionary."""
    iterations = tuple(IterationReport(**dict(i, solver=SolverReport(**i["solver"])))
                       for i in members["iterations"])
    stages = tuple(StageReport(**s) for s in members["stages"])
    return Report(**dict(members, unexplained_center=tuple(members["unexplained_center"]),
                         warnings=tuple(members["warnings"]), iterations=iterations,
                         stages=stages))
