# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the paper claims, in our words, beside what was measured. Holds or not is decided by the numbers of a report."""

from dataclasses import dataclass
from pathlib import Path

from tables import METHOD_NAMES, ROWS, Table, name_of_input, speed_up, total_seconds


@dataclass(frozen=True)
class Claim:
    where: str
    text: str
    measured: str
    holds: bool


def ratio_list(values):
    return ", ".join(f"{value:.2f}" for value in values)


def speed_claims(report):
    models = report["table_1"]
    rows = [speed_up(model["runs"], "rows") for model in models]
    block = [speed_up(model["runs"], "block") for model in models]
    gain = [total_seconds(model["runs"], "LOR", "rows") / total_seconds(model["runs"], "LOR", "block") for model in models]
    nearest = min(models, key=lambda model: abs(model["input_points"] - 10000))
    on_processor = total_seconds(nearest["runs"], "LOR", "rows")
    return [Claim("Table 1", "ALOR is about an order of magnitude faster than LOR.",
                  f"With the paper's rows and CGLS: {ratio_list(rows)} times.", min(rows) >= 5),
            Claim("Section 4", "On a processor, Algorithm 1 takes several hours for 10000 points.",
                  f"LOR by rows, one thread, {name_of_input(nearest)}: {on_processor:.3g} s; collapsed "
                  f"{total_seconds(nearest['runs'], 'LOR', 'block'):.3g} s.", on_processor >= 3600),
            Claim("Section 4.1", "Half-sampling saves time, since it shortens the matrix.",
                  f"It does for the paper's rows. The fit term collapses exactly to one weight and one point a sample, though: "
                  f"LOR by rows takes {ratio_list(gain)} times as long as LOR collapsed, and ALOR collapsed is {ratio_list(block)} times as fast as LOR collapsed, "
                  "which is what interleaving saves.", min(block) >= 2)]


def device_claims(report):
    runs = report["device_runs"]
    first = next(run for run in runs["runs"] if run["method"] == "alor")
    times = {run["method"]: f"{METHOD_NAMES[run['method']]} {1e3 * run['total']:.3g} ms" for run in runs["runs"] if run["input_points"] == first["input_points"]}
    return [Claim("Section 7", "Even ALOR is far from interactive, which would be milliseconds.",
                  f"Collapsed, on one {runs['device']}, {first['input_points']} points to {first['output_points']}: {', '.join(times.values())}.",
                  first["total"] >= 0.1)]


def equation_claims(report):
    values = [study["evaluation"]["uniformity"]["density_variation"] for study in report["equations"]["studies"]]
    return [Claim("Fig. 2", "Eq. (6) gives the most even density, Eq. (4) a more even one than Eq. (3).",
                  "Coefficients of variation of the local density, Eq. (3), (4), (6): " + ", ".join(f"{value:.4f}" for value in values) + ".",
                  values[2] < values[1] < values[0])]


def half_sampling_claims(report):
    errors = {study["title"]: study["mesh_distance"] for study in report["half_sampling"]["studies"]}
    text = "Algorithm 2 loses less than a smaller radius or a random half."
    if None in errors.values():
        return [Claim("Fig. 4", text, "One of the results has no Poisson mesh.", False)]
    listed = ", ".join(f"{title} {error:.4f} %" for title, error in errors.items())
    merged = errors["Algorithm 2"]
    return [Claim("Fig. 4", text, f"Mean distance of the Poisson mesh: {listed}.",
                  merged <= errors["smaller radius"] and merged <= errors["random half"])]


def interleaving_claims(report):
    full, interleaved = (study["densities_over_iterations"] for study in report["interleaving"]["studies"])
    largest = max(abs(a - b) for x, y in zip(full, interleaved) for a, b in zip(x, y))
    excess = max(value for densities in full for value in densities) - 1
    return [Claim("Fig. 5", "Interleaved regularization hardly changes the local density of a sample.",
                  f"Of three samples over all iterations it changes by {largest:.3f} at most; the density's own excess over 1 is up to {excess:.3f}.",
                  largest < 0.1 * excess)]


def normal_weight_claims(report):
    runs = report["normal_weights"]["runs"]
    distances = [run["evaluation"]["distance"]["mean"] for run in runs]
    listed = ", ".join(f"λ {run['normal_weight']:g}: {value:.4f} %" for run, value in zip(runs, distances))
    return [Claim("Fig. 6", "A larger normal weight removes more noise.", f"Mean distance: {listed}.",
                  all(b <= a * 1.001 for a, b in zip(distances, distances[1:])))]


OURS = ("LOR", "ALOR", "default")


class Measured:
    """What was measured of the methods on one input. The others are those that the paper names."""

    def __init__(self, experiment):
        self.runs = {name: run for name, run in experiment["measurements"].items() if run}
        self.others = [row.name for row in ROWS if row.name not in OURS and row.name in self.runs]

    def distance(self, name):
        return self.runs[name]["evaluation"]["distance"]["mean"]

    def spacing_variation(self, name):
        return self.runs[name]["evaluation"]["uniformity"]["spacing_variation"]

    def closest(self, names):
        return min(names, key=self.distance)

    def distances(self, names):
        return ", ".join(f"{name} {self.distance(name):.4f} %" for name in names)

    def spacing_variations(self, names):
        return ", ".join(f"{name} {self.spacing_variation(name):.3f}" for name in names)


def comparison_claims(report):
    experiment, where = report["comparison"], "Fig. 1"
    measured = Measured(experiment)
    paper, rival = measured.closest(("LOR", "ALOR")), measured.closest(measured.others)
    return [Claim(where, "LOR and ALOR are closer to the surface than the other methods.",
                  f"{name_of_input(experiment)}. Mean distance: {measured.distances((paper, rival, 'default'))}; "
                  f"{rival} is the best of the others.", measured.distance(paper) <= measured.distance(rival)),
            Claim(where, "ALOR is as good as LOR, or better.", f"Mean distance: {measured.distances(('LOR', 'ALOR'))}.",
                  measured.distance("ALOR") <= 1.01 * measured.distance("LOR")),
            Claim(where, "They are more evenly spread than LOD.", f"NN6 cv: {measured.spacing_variations((*OURS, 'LOD'))}.",
                  max(map(measured.spacing_variation, ("LOR", "ALOR"))) < measured.spacing_variation("LOD")),
            Claim(where, "WLOP is more evenly spread than LOP.", f"NN6 cv: {measured.spacing_variations(('WLOP', 'LOP'))}.",
                  measured.spacing_variation("WLOP") < measured.spacing_variation("LOP"))]


def noise_claims(report):
    strong = [(experiment, Measured(experiment)) for experiment in report["noise"]]
    pairs = [(measured.distance(measured.closest(("LOR", "ALOR"))), measured.distance(measured.closest(measured.others))) for _, measured in strong]
    listed = "; ".join(
        f"{Path(experiment['mesh']).stem} {experiment['noise_percent']:g} %: "
        + measured.distances((measured.closest(("LOR", "ALOR")), measured.closest(measured.others), "default")) for experiment, measured in strong)
    return [Claim("Section 5", "LOR and ALOR stand noise of 1 to 2 % better than the other methods.",
                  f"Mean distance, also of the best of the others: {listed}.", all(ours <= theirs for ours, theirs in pairs))]


def thin_plate_claims(report):
    measured = {name: report["thin_plate"]["measurements"][name]["evaluation"] for name in OURS}
    listed = ", ".join(f"{name} {evaluation['distance']['mean']:.3f} % / {evaluation['normals']['share_inwards'] * 100:.2f} % / "
                       f"{evaluation['coverage']['max']:.2f} %" for name, evaluation in measured.items())
    return [Claim("Fig. 12", "The method mixes the two sides of a thin plate; the default method is to keep them apart.",
                  f"Mean distance / normals inwards / largest gap in the coverage: {listed}.",
                  all(measured["default"][part][field] < measured["LOR"][part][field] / 2
                      for part, field in (("distance", "mean"), ("normals", "share_inwards"))))]


CLAIMS = {"table_1": speed_claims, "device_runs": device_claims, "equations": equation_claims, "half_sampling": half_sampling_claims,
          "interleaving": interleaving_claims, "normal_weights": normal_weight_claims, "comparison": comparison_claims, "noise": noise_claims,
          "thin_plate": thin_plate_claims}


def claims(report):
    """Of the experiments that were run."""
    return [claim for name, make in CLAIMS.items() if name in report for claim in make(report)]


def claims_table(report):
    rows = [[claim.where, claim.text, claim.measured, "holds" if claim.holds else "does not hold"] for claim in claims(report)]
    return Table(["where", "claim", "measured", "here"], rows, 4)
