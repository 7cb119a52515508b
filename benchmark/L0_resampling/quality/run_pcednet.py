#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures which points of the public set pcednet-supp are found to lie on edges, beside what was
published for it (Himeur et al. 2021, github.com/STORM-IRIT/pcednet-supp, CC BY 3.0).

Its points are vertices of meshes of the ABC data set, red where they are on a sharp edge; noise
moves them along their normals. So a point on an edge has a distance of zero to it, and the next one
a distance of about a spacing: a point counts as found if it is within half a spacing and a standard
deviation of the noise of a line of the tool. Both are what `l0_resample --info` tells. The tool
gets the places alone, and makes twice as many points, with creases.
"""

import io
import re
import statistics
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import numpy
from scipy.spatial import cKDTree

from quality_bench import Bench, argument_parser, command_line, write_result
from quality_tables import table

PARTS = {"clean": "abc", "noise": "abc_noise_0.04"}
NOISE_OF_SET = 0.004    # of the diagonal, the standard deviation in its files; its page says 4 %
PUBLISHED = {"PCEDNet, 32 scales": "abcreduc32", "PCPNet, trained on ABC": "pcpnetabc",
             "PCEDNet-2C, trained on ABC": "abc", "PCEDNet": "pced",
             "PCEDNet, smooth edges too": "pcedss", "EC-Net": "ecnet",
             "covariance analysis": "ca", "feature edge extraction": "fee"}
LAYOUT = numpy.dtype([(name, "<f4") for name in ("x", "y", "z", "nx", "ny", "nz")]
                     + [(name, "u1") for name in ("red", "green", "blue", "alpha")])
HEADER = "ply\nformat binary_little_endian 1.0\nelement vertex {}\n" + "".join(
    f"property {'uchar' if LAYOUT[name] == 'u1' else 'float'} {name}\n"
    for name in LAYOUT.names) + "end_header\n"


def read_set(path):
    """Points of a file of the set, and which of them it marks as sharp."""
    header, _, data = path.read_bytes().partition(b"end_header\n")
    number = int(re.search(rb"element vertex (\d+)", header)[1])
    rows = (numpy.loadtxt(io.BytesIO(data), LAYOUT, max_rows=number) if b" ascii " in header else
            numpy.frombuffer(data, LAYOUT, number))
    points = numpy.stack([rows[axis] for axis in "xyz"], axis=1).astype(float)
    return points, (rows["red"] > 0) & (rows["green"] == 0)


def write_small_set(folder):
    """A cube in the form of the set."""
    grid = numpy.linspace(-1, 1, 25)
    points = numpy.stack(numpy.meshgrid(grid, grid, grid), axis=-1).reshape(-1, 3)
    on_faces = (numpy.abs(points) == 1).sum(1)
    rows = numpy.zeros(numpy.count_nonzero(on_faces), LAYOUT)
    noise = (NOISE_OF_SET * 2 * 3 ** 0.5
             * numpy.random.default_rng(1).standard_normal((len(rows), 3)))
    rows["red"] = numpy.where(on_faces[on_faces > 0] > 1, 168, 255)
    rows["green"] = numpy.where(on_faces[on_faces > 0] > 1, 0, 255)
    for part, moved in (("abc", 0 * noise), ("abc_noise_0.04", noise)):
        for axis, values in zip("xyz", (points[on_faces > 0] + moved).T):
            rows[axis] = values
        path = folder / "scripts" / "3dmodels" / part / "gt" / "cube.ply"
        path.parent.mkdir(parents=True)
        path.write_bytes(HEADER.format(len(rows)).encode("ascii") + rows.tobytes())


def labels_of(folder, part):
    """The folders of the labelled points, by the lower-case names of their methods."""
    return {path.name.lower(): path for path in (folder / "scripts" / "3dmodels" / part).iterdir()
            if path.is_dir()}


def f1(truth, found):
    right = numpy.count_nonzero(truth & found)
    return 2 * right / max(numpy.count_nonzero(truth) + numpy.count_nonzero(found), 1)


def points_of_lines(path, step):
    """Points along the lines of an OBJ file."""
    words = [line.split() for line in path.read_text(encoding="ascii").splitlines()]
    vertices = numpy.array([word[1:4] for word in words if word[:1] == ["v"]], float)
    points = [numpy.empty((0, 3))]
    for line in (numpy.array(word[1:], int) - 1 for word in words if word[:1] == ["l"]):
        for a, b in zip(vertices[line[:-1]], vertices[line[1:]]):
            points.append(numpy.linspace(a, b, 2 + int(numpy.linalg.norm(b - a) / step)))
    return numpy.concatenate(points)


def measure(build, part, source):
    points, truth = read_set(source)
    with tempfile.TemporaryDirectory() as scratch:
        bench, lines = Bench(build / "bin", Path(scratch), 1), Path(scratch) / "creases.obj"
        told = bench.run("l0_resample", "--info", source, "--quiet")
        spacing, noise = (float(re.search(rf"^{name}: +(\S+)", told, re.MULTILINE)[1])
                          for name in ("spacing", "noise"))
        bench.run("l0_resample", source, bench.scratch / "result.ply", "--quiet", "--percentage",
                  200, "--device", "cpu", "--threads", bench.threads, "--creases", lines)
        along = points_of_lines(lines, spacing / 10)
    found = numpy.zeros(len(points), bool)
    if len(along):
        found = cKDTree(along).query(points)[0] <= spacing / 2 + noise
    run = {"part": part, "shape": source.stem, "points": len(points), "spacing": spacing,
           "noise": noise, "edge_points": int(truth.sum()), "found": int(found.sum()),
           "right": int((truth & found).sum()), "f1": f1(truth, found)}
    print(f"{source.stem}, {part}: F1 {run['f1']:.3f}", file=sys.stderr, flush=True)
    return run


def published_of_shapes(folder, part, method, shapes):
    """F1 of the labels that the set has of a method; less than all of the shapes where its files
    are of other points."""
    labels = labels_of(folder, part)
    found = []
    for shape in shapes if method in labels else ():
        truth = read_set(labels["gt"] / f"{shape}.ply")[1]
        path = labels[method] / f"{shape}.ply"
        marked = read_set(path)[1] if path.exists() else ()
        if len(marked) == len(truth):
            found.append(f1(truth, marked))
    return found


def published_of_all(folder, part, method):
    """The median as the page of the set has it, of the shapes where there is an F1, or None."""
    path = folder / "scripts" / "data" / part / f"{method}.txt"
    if not path.exists():
        return None
    precision, recall = numpy.loadtxt(path, usecols=(0, 1)).T
    with numpy.errstate(invalid="ignore"):
        return float(numpy.nanmedian(2 * precision * recall / (precision + recall)))


def median_cell(values, number):
    if not values:
        return "-"
    return f"{statistics.median(values):.2f}" + f" ({len(values)})" * (len(values) < number)


def markdown(result):
    runs = result["runs"]
    shapes = list(dict.fromkeys(run["shape"] for run in runs))
    of_ours = {part: [run for run in runs if run["part"] == part] for part in PARTS}
    lines = ["# Edge points of pcednet-supp", "", "Made by", "",
             *(f"    {command}" for command in result["commands"]), "",
             "Median F1 of points on edges, clean and with noise along the normals of "
             f"{100 * NOISE_OF_SET:g} % of the diagonal, which the set calls 0.04. Of the "
             f"{len(shapes)} shapes of which the set has points, and of all 7167 of which it has "
             "figures. A number in brackets is that of the shapes, where files of some are of "
             "other points. The files have normals that the noise has not moved, which the tool "
             "does not get. From github.com/STORM-IRIT/pcednet-supp (Himeur et al. 2021, CC BY "
             "3.0): scripts/data for all shapes; for the others, the red points of "
             "scripts/3dmodels.", ""]
    header = ["method", "clean", "noise", "clean, all shapes", "noise, all shapes"]
    rows = [["default", *(median_cell([run["f1"] for run in of_part], len(shapes))
                          for of_part in of_ours.values()), "-", "-"]]
    for name, columns in result["published"].items():
        rows.append([name, *(median_cell(columns["shapes"][part], len(shapes)) for part in PARTS),
                     *("-" if columns["all"][part] is None else f"{columns['all'][part]:.2f}"
                       for part in PARTS)])
    lines.append(table(header, rows))
    header = ["shape", "points", "edge points",
              *(f"{what}, {part}" for part in PARTS
                for what in ("F1", "precision", "recall", "noise, spacings"))]
    rows = [[clean["shape"], clean["points"], clean["edge_points"],
             *(cell for run in (clean, noisy) for cell in
               map("{:.2f}".format, (run["f1"], run["right"] / max(run["found"], 1),
                                     run["right"] / max(run["edge_points"], 1),
                                     run["noise"] / run["spacing"])))]
            for clean, noisy in zip(*of_ours.values(), strict=True)]
    lines += ["## Shapes", "", table(header, [[str(cell) for cell in row] for row in rows])]
    return "\n".join(lines)


def main():
    parser = argument_parser(__doc__, "a cube alone, to see that everything runs")
    parser.add_argument("folder", type=Path, nargs="?", help="of the set; not with --small")
    parser.add_argument("--jobs", type=int, default=1, help="shapes at a time")
    arguments = parser.parse_args()
    if (arguments.folder is None) != arguments.small:
        parser.error("the folder of the set, or --small")
    with tempfile.TemporaryDirectory() as scratch, ThreadPoolExecutor(arguments.jobs) as pool:
        folder = arguments.folder or Path(scratch)
        if arguments.small:
            write_small_set(folder)
        measured = [pool.submit(measure, arguments.build, name, source)
                    for name, part in PARTS.items()
                    for source in sorted(labels_of(folder, part)["gt"].glob("*.ply"))]
        runs = [one.result() for one in measured]
        shapes = sorted({run["shape"] for run in runs})
        published = {name: {"shapes": {key: published_of_shapes(folder, part, method, shapes)
                                       for key, part in PARTS.items()},
                            "all": {key: published_of_all(folder, part, method)
                                    for key, part in PARTS.items()}}
                     for name, method in PUBLISHED.items()}
    result = {"commands": [command_line("run_pcednet.py", sys.argv[1:])], "runs": runs,
              "published": published}
    write_result(arguments.output, result, markdown(result))


if __name__ == "__main__":
    main()
