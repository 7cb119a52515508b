# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""What stands in a report, section by section, as Markdown."""

import textwrap
from pathlib import Path

import tables
from claims import claims_table

MEASURES = """Lengths are % of the diagonal of the bounding box. Distance is from the points to the
mesh, coverage from the mesh to the nearest point. A normal's error disregards its sign, which the
next column counts. Edges are those of 30 degrees and more; recall is the share of their length with
a point within two median spacings. NN6 cv is the coefficient of variation of the mean distance to
the 6 nearest neighbors, density cv that of Eq. (5). Recall and evenness mean little where the
distance is large. Seconds are wall-clock time beside other programs, so they tell orders of
magnitude only; MiB is what the resident memory grew by. The best figure of a column is bold.
Poisson meshes are CGAL's, and a column has their mean distance. There is none where the normals
contradict each other."""

METHODS = """Some methods are run with several radii. The one with the least mean distance counts,
and is named. Radii are multiples of the average spacing, as CGAL's WLOP counts them. LOP, KLOP,
WLOP and CLOP get PCA normals oriented over a spanning tree."""

TIMING = """One thread, one run after the other, the fastest of three. The paper's times are from an
Intel i7-4770 with a GTX 780, for its own noise. Init is all that is in no other column: neighbors,
PCA, densities, orientation of the result. OLHS is the listing of the halved fit rows; where LOR
lists all of them, that counts for Init. The collapsed problem is the same with one weight and one
point a sample. Noise is 0.5 %. FIFA, Box and Clock cannot be had, and real scans stand for them;
Lord Quas cannot either, and Fig. 6 has the armadillo in its place."""

DEVICE = """Not measured by this run, but committed. The columns are by the device's clock, the total
by the host's."""

HALF_SAMPLING = """Half of the neighbors of each sample by a smaller radius (three quarters), at
random, and by one pass of Algorithm 2."""

SELECTIONS = {"full": "The numbers of points are the paper's.",
              "tiny": "The numbers of points are a hundredth of the paper's, for a test of this "
                      "report: its figures mean nothing."}


def section(title, *parts):
    return f"## {title}\n\n" + "\n".join(parts)


def paragraph(text):
    return textwrap.fill(" ".join(text.split()), 100, break_long_words=False,
                         break_on_hyphens=False) + "\n"


def commands(*lines):
    return "".join(f"    {line}\n" for line in lines)


def introduction(result):
    machine, minutes = result["machine"], sum(result["seconds"].values()) / 60
    return "\n".join([
        "# The paper's tables and figures\n",
        paragraph(f"{SELECTIONS[result['selection']]} {machine['cores']} cores of "
                  f"{machine['processor']} (load average before: "
                  f"{machine['load_average_before']:.1f}), {machine['compiler']}, "
                  f"{machine['flags']}. The experiments took {minutes:.1f} minutes."),
        paragraph(MEASURES), commands(*result["commands"])])


def study_section(title, experiment, text=""):
    return section(title, paragraph(f"{tables.name_of_input(experiment)}. {text}"),
                   tables.study_table(experiment).markdown())


def comparison_section(title, experiment, text=""):
    return section(title, paragraph(f"{tables.name_of_input(experiment)}. {text}"),
                   tables.comparison_table(experiment).markdown())


def table_1(report):
    return section("Table 1", paragraph(TIMING), tables.printed_table_1().markdown(),
                   tables.table_1(report).markdown())


def device_runs(report):
    return section("Table 1 on a CUDA device", paragraph(DEVICE),
                   commands(report["device_runs"]["command"]),
                   tables.device_table(report).markdown(),
                   tables.beside_device_table(report).markdown())


def equations(report):
    return study_section("Fig. 2: the local density after Eq. (3), (4) and (6)",
                         report["equations"], "Eq. (3) and (4) run with the paper's rows.")


def half_sampling(report):
    return study_section("Fig. 4: fewer original neighbors", report["half_sampling"],
                         HALF_SAMPLING)


def interleaving(report):
    return study_section("Fig. 5: interleaved regularization", report["interleaving"])


def normal_weights(report):
    experiment = report["normal_weights"]
    return section("Fig. 6: the normal weight λ",
                   paragraph(f"{tables.name_of_input(experiment)}, ALOR."),
                   tables.normal_weight_table(experiment).markdown())


def comparison(report):
    experiment = report["comparison"]
    return comparison_section(f"Fig. 1: {Path(experiment['mesh']).stem}", experiment)


def thin_plate(report):
    return comparison_section("Fig. 12: a thin plate", report["thin_plate"],
                              "The paper's failure case.")


def noise(report):
    return "\n".join(comparison_section(f"Noise of {experiment['noise_percent']:g} %", experiment)
                     for experiment in report["noise"])


# Those of experiments, in their order
SECTIONS = (table_1, device_runs, equations, half_sampling, interleaving, normal_weights,
            comparison, thin_plate, noise)


def markdown(result):
    """Of the experiments that were run."""
    report = result["experiments"]
    return "\n".join([
        introduction(result),
        section("What the paper says, and what was measured",
                paragraph("The other methods are those that the paper names."),
                claims_table(report).markdown()),
        section("Methods", paragraph(METHODS), tables.methods_table().markdown()),
        *(make(report) for make in SECTIONS if make.__name__ in report)])
