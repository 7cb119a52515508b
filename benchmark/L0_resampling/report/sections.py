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
from claims import claims_table

FOLDER = Path(__file__).resolve().parent
THREE = Path("/usr/share/javascript/three")    # Debian: libjs-three

VERDICTS = {"holds": "holds", "does not hold": "fails"}    # in words, and the class of the cell


@dataclass
class Figure:
    """Scenes of a mesh or scan for the viewer, all with one camera."""
    scenes: list
    mesh: str
    noise_percent: float = None


@dataclass
class Section:
    title: str
    text: list
    tables: list = field(default_factory=list)
    further: list = field(default_factory=list)  # tables that the page folds
    plots: list = field(default_factory=list)    # SVG
    figure: Figure = None
    commands: list = field(default_factory=list)


MEASURES = (
    "Lengths are % of the diagonal of the bounding box. Distance is from the points to the mesh, coverage from the mesh to the nearest "
    "point. A normal's error disregards its sign, which the next column counts. Edges are those of 30 degrees and more; recall is the share "
    "of their length with a point within two median spacings. NN6 cv is the coefficient of variation of the mean distance to the 6 nearest "
    "neighbors, density cv that of Eq. (5). Recall and evenness mean little where the distance is large. Seconds are wall-clock time beside other programs, "
    "so they tell orders of magnitude only; MiB is what the resident memory grew by. The best figure of a column is bold. Poisson meshes are CGAL's, and a "
    "column has their mean distance. There is none where the normals contradict each other.")


def introduction(result):
    machine = result["machine"]
    minutes = sum(result["seconds"].values()) / 60
    selection = {"full": "The numbers of points are the paper's.", "small": "The numbers of points are a twentieth of the paper's, and a quarter for the thin plate. "
                 "The paper's radius grows as points get fewer, so that LOR and ALOR fare worse here than with the paper's numbers.",
                 "tiny": "The numbers of points are a hundredth of the paper's, for a test of this report: its figures mean nothing."}[result["selection"]]
    return Section("", [f"{selection} {machine['cores']} cores of {machine['processor']} (load average before: "
                        f"{machine['load_average_before']:.1f}), {machine['compiler']}, {machine['flags']}. The experiments took {minutes:.1f} minutes.", MEASURES],
                   commands=result["commands"])


def methods_section():
    return Section("Methods", ["Some methods are run with several radii or numbers of neighbors. The one with the least mean distance counts, and is named; where no "
                               "truth is known, the first. Radii are multiples of the average spacing, as CGAL's WLOP counts them. LOP, KLOP, WLOP, CLOP and the simplifications get "
                               "PCA normals oriented over a spanning tree."], [tables.methods_table()])


def claims_section(report):
    return Section("What the paper says, and what was measured", ["The other methods are those that the paper names."], [claims_table(report)])


def timing_section(report):
    return Section("Table 1", [
        "One thread, one run after the other, the fastest of three. The paper's times are from an Intel i7-4770 with a GTX 780, for its own noise. Init is all that is in no "
        "other column: neighbors, PCA, densities, orientation of the result. OLHS is the listing of the halved fit rows; where LOR lists all of them, "
        "that counts for Init. Block CG solves the same problem with its fit term collapsed to one weight and one point a sample. Noise is 0.5 %. "
        "FIFA, Box and Clock cannot be had, and real scans stand for them; Lord Quas cannot either, and Fig. 6 has the armadillo in its place."], [
        tables.printed_table_1(), tables.table_1(report)])


def study_section(title, experiment, text, plot):
    return Section(title, [f"{tables.name_of_input(experiment)}. {text}"], [tables.study_table(experiment)],
                   plots=[plot] if plot else [], figure=Figure([study["scene"] for study in experiment["studies"]], experiment["mesh"], experiment["noise_percent"]))


def comparison_section(experiment, title, text):
    measured = [run for run in experiment["measurements"].values() if run]
    return Section(title, [f"{tables.name_of_input(experiment)}. {text}".strip()], [tables.comparison_table(experiment)],
                   [tables.further_table(experiment)] if tables.has_truth(experiment) else [],
                   figure=Figure([experiment["input_scene"], *(run["scene"] for run in measured)], experiment["mesh"], experiment.get("noise_percent")))


def normal_weight_section(report):
    experiment = report["normal_weights"]
    return Section("Fig. 6: the normal weight λ", [f"{tables.name_of_input(experiment)}, ALOR."], [tables.normal_weight_table(experiment)],
                   figure=Figure([run["scene"] for run in experiment["runs"]], experiment["mesh"], experiment["noise_percent"]))


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
            yield Section("", [tables.name_of_input(experiment)], [tables.comparison_table(experiment)],
                          [tables.further_table(experiment)])


def device_section(report):
    return Section("Table 1 on a CUDA device",
                   ["Not measured by this run, but committed. The columns are by the device's clock, the total by the host's."],
                   [tables.device_table(report), tables.beside_device_table(report)], commands=[report["device_runs"]["command"]])


def equations_section(report):
    return study_section("Fig. 2: the local density after Eq. (3), (4) and (6)", report["equations"], "Eq. (3) and (4) run with the paper's rows.",
                         plots.histograms(report["equations"]))


def half_sampling_section(report):
    return study_section("Fig. 4: fewer original neighbors", report["half_sampling"],
                         "Half of the neighbors of each sample by a smaller radius (three quarters), at random, and by one pass of Algorithm 2.", None)


def interleaving_section(report):
    return study_section("Fig. 5: interleaved regularization", report["interleaving"], "The local density of three samples.",
                         plots.densities_over_iterations(report["interleaving"]))


def comparison_sections(report):
    return [comparison_section(experiment, f"Fig. {experiment['figure']}: {Path(experiment['mesh']).stem}", "") for experiment in report["comparisons"]]


def scan_sections(report):
    return [comparison_section(experiment, f"Fig. {experiment['figure']}: {Path(experiment['mesh']).stem}, in place of {experiment['stands_for']}",
                               "The paper's scan cannot be had. Of this one nobody knows the truth, so there are only pictures.")
            for experiment in report["scans"]]


def thin_plate_section(report):
    left_out = report["thin_plate"]["left_out"]
    return comparison_section(report["thin_plate"], "Fig. 12: a thin plate",
                              "The paper's failure case." + (f" Left out for the time they take: {', '.join(left_out)}." if left_out else ""))


# Experiments of a report, in the order of their sections
SECTIONS = {"table_1": timing_section, "device_runs": device_section, "equations": equations_section, "half_sampling": half_sampling_section,
            "interleaving": interleaving_section, "normal_weights": normal_weight_section, "comparisons": comparison_sections,
            "scans": scan_sections, "thin_plate": thin_plate_section, "noise": noise_sections}


def all_sections(result):
    """Of the experiments that were run."""
    report = result["experiments"]
    parts = [introduction(result), claims_section(report), methods_section()]
    for name, make in SECTIONS.items():
        if name in report:
            made = make(report)
            parts += [made] if isinstance(made, Section) else made
    return parts


def markdown(parts):
    lines = ["# The paper's tables and figures\n"]
    for part in parts:
        if part.title:
            lines.append(f"## {part.title}\n")
        lines += [f"{text}\n" for text in part.text]
        lines += ["".join(f"    {command}\n" for command in part.commands)] if part.commands else []
        lines += [table.markdown() for table in part.tables + part.further]
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
    shown = [{**vars(part), "figure": part.figure and scenes.pack_figure(part.figure.scenes, files, part.figure.mesh, part.figure.noise_percent)} for part in parts]
    # "</script>" within a script would end it
    scripts = [path.read_text(encoding="utf-8").replace("</script", "<\\/script")
               for path in (THREE / "three.min.js", THREE / "examples/js/controls/OrbitControls.js", FOLDER / "viewer.js")]
    return environment.get_template("page.html").render(sections=shown, verdicts=VERDICTS, scripts=scripts,
                                                        css=(FOLDER / "page.css").read_text(encoding="utf-8"))
