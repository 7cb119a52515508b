# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""The table of methods. All programs have one interface:

    PROGRAM INPUT.ply OUTPUT.ply --points COUNT [options]

which writes oriented points and prints one line of JSON with times and memory (method_program.h).
"""

from dataclasses import dataclass

# The example of CGAL's manual for edge-aware upsampling; its defaults, 30 degrees and 1, take far longer to insert
EAR_EXAMPLE = ("--sharpness-angle", 25, "--edge-sensitivity", 0)


@dataclass(frozen=True)
class Method:
    program: str
    options: tuple
    is_exact: bool = True    # edge-aware upsampling may stop before it has all points


def ours(name):
    return Method("run_l0", ("--method", name))


def wlop(radius, *options):
    return Method("baseline_wlop", ("--radius-in-spacings", radius, *options))


def ear(radius, smoothing="after"):
    """With bilateral smoothing after WLOP, as CGAL's example has it, of the input first, or both."""
    return Method("baseline_ear", ("--radius-in-spacings", radius, *EAR_EXAMPLE, "--smoothing", smoothing), False)


def projection(program, radius, *options):
    """LOP's kernel is as wide as that of CGAL's WLOP at half the radius."""
    return Method(program, ("--radius-in-spacings", 2 * radius, *options))


def simple_filter(name, *options):
    return Method("baseline_filter", ("--filter", name, *options))


@dataclass(frozen=True)
class Row:
    """A method by its name in tables: those that the paper names, and ours. Of its variants the best one counts.

    `remark` says where it is from; without variants, why it cannot be run.
    """
    name: str
    variants: dict
    remark: str


RADII = (4, 6)    # in spacings of the input, as CGAL counts them


def at_each_radius(make, radii=RADII):
    return {f"radius {radius}": make(radius) for radius in radii}


def projections(program, *options):
    """At CGAL's default radius too, since without density weights less holds the samples down."""
    return at_each_radius(lambda radius: projection(program, radius, *options), (*RADII, 8))


ROWS = (
    Row("LOR", {"": ours("lor")}, "Section 3 of the paper, our implementation"),
    Row("ALOR", {"": ours("alor")}, "Section 4 of the paper, our implementation"),
    Row("default", {"": ours("default")}, "this package's own method, not the paper's"),
    Row("LOP", projections("baseline_lop"), "Lipman 2007, our implementation"),
    Row("KLOP", projections("baseline_lop", "--kernel-density-share", 30),
        "LOP on 30 % of the points, drawn from their kernel density estimate as in Liao 2013, our implementation"),
    Row("WLOP", at_each_radius(wlop) | {f"radius {radius}, uniform": wlop(radius, "--require-uniform-sampling")
                                        for radius in RADII}, "CGAL's"),
    Row("CLOP", projections("baseline_clop"),
        "Preiner 2014, our implementation"),
    Row("PPU", {}, "Wang 2019: a trained network, whose weights cannot be had"),
    Row("EAR", at_each_radius(ear),
        "CGAL's functions in the paper's protocol: WLOP to two thirds of the points, then upsampling"),
    Row("LOD", {"": Method("baseline_lod", ())}, "Sun 2015 without its upsampling, our implementation"),
)
