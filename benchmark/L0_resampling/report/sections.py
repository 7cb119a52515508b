# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""What stands in a report, section by section, and how it becomes Markdown and a page."""

from dataclasses import dataclass, field
from pathlib import Path

import jinja2
import markupsafe

import plots
import scenes
import tables
from claims import claims

FOLDER = Path(__file__).resolve().parent
THREE = Path("/usr/share/javascript/three")    # Debian: libjs-three

VERDICTS = {"holds": "holds", "does not hold": "fails"}    # in words, and the class of the cell


@dataclass
class Figure:
    """Scenes for the viewer, all with one camera."""
    scenes: list
    noise_percent: float = None


@dataclass
class Section:
    title: str
    text: list
    tables: list = field(default_factory=list)
    plots: list = field(default_factory=list)    # SVG
    figure: Figure = None
    commands: list = field(default_factory=list)


MEASURES = (
    "Lengths are % of the diagonal of the bounding box. Distance is from the points to the mesh, coverage from the mesh to the nearest "
    "point. A normal's error disregards its sign, which the next column counts. Edges are those of 30 degrees and more; recall is the share "
    "of their length with a point within two median spacings. NN6 cv is the coefficient of variation of the mean distance to the 6 nearest "
    "neighbors, density cv that of Eq. (5). Recall and evenness mean little where the distance is large. Seconds are wall-clock time beside other programs, "
    "so they tell orders of magnitude only; MiB is what the resident memory grew by. Radii are multiples of the average spacing, as CGAL's WLOP "
    "counts them; of several the one with the least mean distance counts, and is named. The best figure of a column is bold. "
    "LOP, KLOP, WLOP and CLOP get PCA normals oriented over a spanning tree.")


def introduction(result):
    machine = result["machine"]
    selection = {"full": "The numbers of points are the paper's.", "small": "The numbers of points are a tenth of the paper's, and a fortieth in the tables of noise. "
                 "The paper's radius grows as points get fewer, so that LOR and ALOR fare worse here than with the paper's numbers.",
                 "smoke": "As few points as make sense, to see that everything runs."}[result["selection"]]
    return Section("", [f"{selection} {machine['cores']} cores of {machine['processor']} (load average before: "
                        f"{machine['load_average_before']:.1f}), {machine['compiler']}, {machine['flags']}.", MEASURES],
                   commands=result["commands"])


def claims_section(report):
    rows = [[claim.where, claim.text, claim.measured, "holds" if claim.holds else "does not hold"] for claim in claims(report)]
    return Section("What the paper says, and what was measured", [], [tables.Table(["where", "claim", "measured", "here"], rows, 4)])


def timing_section(report):
    return Section("Table 1: seconds", [
        "One thread, one run after the other, the fastest of three. The paper's times are from an Intel i7-4770 with a GTX 780, for its own noise. Init is all that is in no "
        "other column: neighbors, PCA, densities, orientation of the result. OLHS is the listing of the halved fit rows; where LOR lists all of them, "
        "that counts for Init. Noise is 0.5 %."], [tables.table_1(report)])


def study_section(title, experiment, text, plot):
    return Section(title, [f"{tables.name_of_input(experiment)}. {text}"], [tables.study_table(experiment)], [plot] if plot else [],
                   Figure([study["scene"] for study in experiment["studies"]], experiment["noise_percent"]))


def comparison_section(experiment, title, text):
    measured = [run for run in experiment["measurements"].values() if run]
    return Section(title, [f"{tables.name_of_input(experiment)}. {text}"], [tables.comparison_table(experiment)],
                   figure=Figure([experiment["input_scene"], *(run["scene"] for run in measured)], experiment.get("noise_percent")))


def normal_weight_section(report):
    experiment = report["normal_weights"]
    return Section("Fig. 6: the normal weight λ", [f"{tables.name_of_input(experiment)}, ALOR."], [tables.normal_weight_table(experiment)],
                   figure=Figure([run["scene"] for run in experiment["runs"]], experiment["noise_percent"]))


def noise_sections(report):
    by_mesh = {}
    for experiment in report["noise"]:
        by_mesh.setdefault(experiment["mesh"], []).append(experiment)
    for mesh, experiments in by_mesh.items():
        drawn = []
        if len(experiments) > 1:
            drawn = [plots.against_noise(experiments, "mean distance, %", lambda e: e["distance"]["mean"]),
                     plots.against_noise(experiments, "normal error, degrees", lambda e: e["normals"]["mean_error_degrees"])]
        yield Section(f"Noise: {Path(mesh).stem}", [], plots=drawn)
        for experiment in experiments:
            yield Section("", [tables.name_of_input(experiment)], [tables.comparison_table(experiment)])


def all_sections(result):
    report = result["experiments"]
    parts = [introduction(result), claims_section(report), timing_section(report),
             Section("On a CUDA device", [f"Not measured here, but committed: one {report['device_runs']['device']}, points and result on the device."],
                     [tables.device_table(report)], commands=[report["device_runs"]["command"]]),
             study_section("Fig. 2: the local density after Eq. (3), (4) and (6)", report["equations"], "Eq. (3) and (4) run with the paper's rows.",
                           plots.histograms(report["equations"])),
             study_section("Fig. 4: fewer original neighbors", report["half_sampling"],
                           "Half of the neighbors of each sample by a smaller radius (three quarters), at random, and by one pass of Algorithm 2.", None),
             study_section("Fig. 5: interleaved regularization", report["interleaving"], "The local density of three samples.",
                           plots.densities_over_iterations(report["interleaving"])),
             normal_weight_section(report)]
    for experiment in report["comparisons"]:
        parts.append(comparison_section(experiment, f"Fig. {experiment['figure']}", ""))
    for experiment in report["scans"]:
        parts.append(comparison_section(experiment, f"Fig. {experiment['figure']}, on a real scan",
                                        f"It stands for {experiment['stands_for']}, which cannot be had. Nobody knows the truth, so there are only pictures."))
    parts.append(comparison_section(report["thin_plate"], "Fig. 12: a thin plate", "The paper's failure case."))
    return [*parts, *noise_sections(report)]


def markdown(parts):
    lines = ["# The paper's tables and figures\n"]
    for part in parts:
        if part.title:
            lines.append(f"## {part.title}\n")
        lines += [f"{text}\n" for text in part.text]
        lines += ["".join(f"    {command}\n" for command in part.commands)] if part.commands else []
        lines += [table.markdown() for table in part.tables]
    return "\n".join(lines)


def cell(text):
    """As Markdown has it: bold between double stars."""
    if text.startswith("**"):
        return markupsafe.Markup("<b>{}</b>").format(text.strip("*"))
    return markupsafe.escape(text)


def page(parts, files):
    """One self-contained file. Only figures need the files of the run."""
    environment = jinja2.Environment(loader=jinja2.FileSystemLoader(FOLDER), undefined=jinja2.StrictUndefined)
    environment.filters["cell"] = cell
    shown = [{**vars(part), "figure": part.figure and scenes.pack_figure(part.figure.scenes, files, part.figure.noise_percent)} for part in parts]
    # "</script>" within a script would end it
    scripts = [path.read_text(encoding="utf-8").replace("</script", "<\\/script")
               for path in (THREE / "three.min.js", THREE / "examples/js/controls/OrbitControls.js", FOLDER / "viewer.js")]
    return environment.get_template("page.html").render(sections=shown, verdicts=VERDICTS, scripts=scripts,
                                                        css=(FOLDER / "page.css").read_text(encoding="utf-8"))
