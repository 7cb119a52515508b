# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the paper claims, in our words, beside what was measured. Holds or not is decided by the numbers of a report."""

from dataclasses import dataclass

from tables import name_of_input, speed_up, total_seconds


@dataclass(frozen=True)
class Claim:
    where: str
    text: str
    measured: str
    holds: bool


def ratio_list(values):
    return ", ".join(f"{value:.2f}" for value in values)


def speed_claims(report):
    rows = [speed_up(model["runs"], "rows") for model in report["table_1"]]
    block = [speed_up(model["runs"], "block") for model in report["table_1"]]
    gain = [total_seconds(model["runs"], "LOR", "rows") / total_seconds(model["runs"], "LOR", "block") for model in report["table_1"]]
    return [Claim("Table 1", "ALOR is about an order of magnitude faster than LOR.",
                  f"With the paper's rows and CGLS: {ratio_list(rows)} times.", min(rows) >= 5),
            Claim("Section 4.1", "Half-sampling saves time, since it shortens the matrix.",
                  f"It does for the paper's rows. The fit term collapses exactly to one weight and one point a sample, though: "
                  f"LOR by rows takes {ratio_list(gain)} times as long as LOR collapsed, and ALOR collapsed is {ratio_list(block)} times as fast as LOR collapsed, "
                  "which is what interleaving saves.", min(block) >= 2)]


def equation_claim(report):
    values = [study["evaluation"]["uniformity"]["density_variation"] for study in report["equations"]["studies"]]
    return Claim("Fig. 2", "Eq. (6) gives the most even density, Eq. (4) a more even one than Eq. (3).",
                 "Coefficients of variation of the local density, Eq. (3), (4), (6): " + ratio_list(values) + ".",
                 values[2] < values[1] < values[0])


def half_sampling_claim(report):
    errors = {study["title"]: study["scene"].get("mesh_distance", {}).get("mean") for study in report["half_sampling"]["studies"]}
    if None in errors.values():
        return Claim("Fig. 4", "Algorithm 2 loses less than a smaller radius or a random half.", "One mesh could not be made.", False)
    listed = ", ".join(f"{title} {error:.4f} %" for title, error in errors.items())
    merged = errors["Algorithm 2"]
    return Claim("Fig. 4", "Algorithm 2 loses less than a smaller radius or a random half.", f"Mean distance of the Poisson mesh: {listed}.",
                 merged <= errors["smaller radius"] and merged <= errors["random half"])


def interleaving_claim(report):
    full, interleaved = (study["densities_over_iterations"] for study in report["interleaving"]["studies"])
    largest = max(abs(a - b) for x, y in zip(full, interleaved) for a, b in zip(x, y))
    excess = max(value for densities in full for value in densities) - 1
    return Claim("Fig. 5", "Interleaved regularization hardly changes the local density of a sample.",
                 f"Of three samples over all iterations it changes by {largest:.3f} at most; the density's own excess over 1 is up to {excess:.3f}.",
                 largest < 0.1 * excess)


def normal_weight_claim(report):
    runs = report["normal_weights"]["runs"]
    distances = [run["evaluation"]["distance"]["mean"] for run in runs]
    listed = ", ".join(f"λ {run['normal_weight']:g}: {value:.4f} %" for run, value in zip(runs, distances))
    return Claim("Fig. 6", "A larger normal weight removes more noise.", f"Mean distance: {listed}.",
                 all(b <= a * 1.001 for a, b in zip(distances, distances[1:])))


def comparison_claims(report):
    claims = []
    for experiment in report["comparisons"]:
        measured = {name: run["evaluation"] for name, run in experiment["measurements"].items() if run}
        ours, others = ("LOR", "ALOR", "default"), [name for name in measured if name not in ("LOR", "ALOR", "default")]

        def best(names):
            return min(names, key=lambda name: measured[name]["distance"]["mean"])

        def shown(name):
            return f"{name} {measured[name]['distance']['mean']:.4f} %"

        paper, rival = best(("LOR", "ALOR")), best(others)
        distances = f"Mean distance: {shown(paper)}, {shown(rival)} (best of the others), {shown('default')}."
        claims.append(Claim(f"Fig. {experiment['figure']}", "LOR and ALOR are closer to the surface than the other methods.",
                            f"{name_of_input(experiment)}. {distances}",
                            measured[paper]["distance"]["mean"] <= measured[rival]["distance"]["mean"]))
        even = min(ours[:2], key=lambda name: measured[name]["uniformity"]["spacing_variation"])
        lod = measured["LOD"]["uniformity"]["spacing_variation"]
        claims.append(Claim(f"Fig. {experiment['figure']}", "They are more evenly spread than LOD.",
                            f"NN6 cv: {even} {measured[even]['uniformity']['spacing_variation']:.3f}, LOD {lod:.3f}, "
                            f"default {measured['default']['uniformity']['spacing_variation']:.3f}.",
                            measured[even]["uniformity"]["spacing_variation"] < lod))
    return claims


def thin_plate_claim(report):
    measured = {name: run["evaluation"] for name, run in report["thin_plate"]["measurements"].items()}
    listed = ", ".join(f"{name} {evaluation['normals']['share_inwards'] * 100:.2f} % / {evaluation['coverage']['max']:.2f} %"
                       for name, evaluation in measured.items())
    return Claim("Fig. 12", "The method mixes the two sides of a thin plate; the default method is to keep them apart.",
                 f"Normals inwards / largest gap in the coverage: {listed}.",
                 measured["default"]["normals"]["share_inwards"] < measured["LOR"]["normals"]["share_inwards"])


def claims(report):
    return [*speed_claims(report), equation_claim(report), half_sampling_claim(report), interleaving_claim(report),
            normal_weight_claim(report), *comparison_claims(report), thin_plate_claim(report)]
