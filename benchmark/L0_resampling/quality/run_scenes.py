#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares the default method with CGAL's pipelines on scans of scenes that are known exactly.

scan_scene makes the scans: a street, a forest, a room and single objects, as a spinning lidar, a
terrestrial scanner, structured light and a range camera see them, from one or several registered
views. There is a table for each measure, and with --output FOLDER/NAME.png has a row of pictures
for each scan and `--pictures` method.
"""

import argparse
import subprocess
import sys
import tempfile
from dataclasses import asdict, dataclass
from pathlib import Path

try:
    import numpy
    import scan_measures
    import scan_pictures
except ImportError as error:
    print(f"skipped: {error}; Debian has it as python3-numpy, python3-scipy or python3-matplotlib")
    sys.exit(77)

import scene_tables
from quality_bench import Bench, command_line, load_raw, mesh_of, raw_file, write_result

sys.path.append(str(Path(__file__).resolve().parents[1] / "methods"))
from methods import ear, ours, simple_filter, wlop


@dataclass(frozen=True)
class Scan:
    """A scan by scan_scene. `error`: of registration, in percent of the scene's diagonal."""

    name: str
    scene: str
    scanner: str
    columns: int
    views: int = 1
    error: float = 0
    slices: str = ""


SCANS = (
    Scan("street, spinning", "street", "spinning", 800, slices="z 1.2 0.4; y 9.3 0.6"),
    Scan("street, spinning, 3 views", "street", "spinning", 360, 3, 0.1, "z 1.2 0.4; y 9.3 0.6"),
    Scan(
        "street, terrestrial, 4 views, 0.2 %",
        "street",
        "terrestrial",
        220,
        4,
        0.2,
        "z 1.2 0.4; x 3 0.5",
    ),
    Scan("forest, terrestrial", "forest", "terrestrial", 440, slices="z 1.3 0.3; z 1.3 0.3 1.4 3.1 1.2"),
    Scan(
        "forest, terrestrial, 4 views, 0.05 %",
        "forest",
        "terrestrial",
        240,
        4,
        0.05,
        "z 1.3 0.3; z 1.3 0.3 1.4 3.1 1.2",
    ),
    Scan(
        "room, structured light",
        "room",
        "structured-light",
        200,
        slices="x 0.2 0.01; x -0.05 0.01 0 0.85 0.5",
    ),
    Scan(
        "room, structured light, 3 views, 0.2 %",
        "room",
        "structured-light",
        120,
        3,
        0.2,
        "x 0.2 0.02; z 0.8 0.02",
    ),
    Scan(
        "bracket, 10 views, 0.2 %",
        "bracket",
        "range-camera",
        75,
        10,
        0.2,
        "z 0.25 0.02; x 0.35 0.02",
    ),
    Scan(
        "bracket, 10 views, 0.5 %",
        "bracket",
        "range-camera",
        75,
        10,
        0.5,
        "z 0.25 0.02; x 0.35 0.02",
    ),
    Scan("torus, 10 views, 0.5 %", "torus", "range-camera", 75, 10, 0.5, "z 0 0.04; x 0 0.04"),
)

METHODS = {
    "default": ours("default"),
    scene_tables.SUBSET: simple_filter("random"),
    **{f"wlop_{radius}": wlop(radius) for radius in (4, 6)},
    "ear_4": ear("baseline_ear", 4),
    "smoothed_ear_4": ear("baseline_smoothed_ear", 4),
    "jet_24": simple_filter("jet", "--neighbors", 24),
    "bilateral_60": simple_filter("bilateral", "--neighbors", 60),
}


def make_scan(bench, scan, seed, columns):
    """The start of the names of the files that scan_scene writes."""
    stem = bench.scratch / "scan"
    scene = scan.scene if scan.scene in ("street", "forest", "room") else mesh_of(scan.scene, None)
    bench.run(
        "scan_scene",
        scene,
        stem,
        "--scanner",
        scan.scanner,
        "--columns",
        columns,
        "--views",
        scan.views,
        "--registration-error",
        scan.error,
        "--seed",
        seed,
    )
    return stem


def measure(bench, method, stem, exact, count):
    """Measures a result, and returns it with its comparison to the exact scan too."""
    path, values = bench.scratch / "result.ply", bench.scratch / "values.bin"
    line = bench.resample(stem.with_suffix(".ply"), method, count, path)
    evaluation = bench.evaluate(f"{stem}_truth.off", method, count, path, "--values", values)
    result = scan_measures.read_cloud(path)
    comparison = scan_measures.Comparison(exact.positions, result.positions)
    shares = comparison.measures()
    unit = evaluation["diagonal_length"] / 100
    distances = numpy.fromfile(values, "<f4").reshape(-1, 2)[:, 0] * unit
    measures = {
        "distance": evaluation["distance"]["mean"] * unit,
        "at_scan": float(distances[comparison.nearest_of_result].mean()),
        "p95": evaluation["distance"]["p95"] * unit,
        "normals": evaluation["normals"]["mean_error_degrees"],
        "inwards": 100 * evaluation["normals"]["share_inwards"],
        "uneven": shares["uneven"],
        "lost": shares["lost"],
        "ghosts": shares["ghosts"],
        "seconds": line["wall_seconds"],
    }
    run = {"program": line["program"], "cgal_version": line["cgal_version"], "measures": measures}
    return run, result, comparison


def parse_arguments():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("build", type=Path, help="build folder; its bin/ has the programs")
    parser.add_argument(
        "--output",
        type=Path,
        metavar="FOLDER/NAME",
        help="what to write, see common/results.py; else the tables are printed",
    )
    parser.add_argument(
        "--only",
        nargs="+",
        default=[""],
        help="scans whose name has one of these; of the others stays what an earlier run has",
    )
    parser.add_argument("--methods", nargs="+", choices=METHODS, default=list(METHODS))
    parser.add_argument(
        "--pictures", nargs="*", choices=METHODS, default=["default"], help="methods to draw"
    )
    parser.add_argument(
        "--keep-baselines",
        action="store_true",
        help="takes from an earlier run what CGAL's pipelines reach on the same scans",
    )
    parser.add_argument(
        "--percentage",
        type=float,
        default=50,
        help="points of the results, in percent of the scan's",
    )
    parser.add_argument("--seed", type=int, default=1, help="of the scanner's errors")
    parser.add_argument(
        "--small",
        action="store_true",
        help="two scans with few rays, four methods, to see that all runs",
    )
    arguments = parser.parse_args()
    if arguments.small:
        arguments.methods = ["default", scene_tables.SUBSET, "wlop_4", "jet_24"]
    if arguments.keep_baselines and arguments.output is None:
        parser.error("--keep-baselines needs the --output of an earlier run")
    return arguments


def earlier_run(arguments):
    output = arguments.output
    if not arguments.keep_baselines and (output is None or not raw_file(output).exists()):
        return {"commands": [], "experiments": []}
    return load_raw(output)


def known_measurements(previous, experiment, methods):
    """Of CGAL's pipelines, from an earlier run on the same scan."""
    for old in previous["experiments"]:
        if all(old[key] == value for key, value in experiment.items() if key != "slices"):
            return {
                name: run
                for name, run in old["measurements"].items()
                if name in methods and name != "default"
            }
    return {}


def measure_scan(bench, scan, arguments, previous):
    """Measures all methods on a scan; returns the experiment and the rows of the page."""
    columns = scan.columns // 3 if arguments.small else scan.columns
    stem = make_scan(bench, scan, arguments.seed, columns)
    cloud = scan_measures.read_cloud(Path(f"{stem}.ply"))
    exact = scan_measures.read_cloud(Path(f"{stem}_exact.ply"))
    count = round(len(cloud) * arguments.percentage / 100)
    experiment = asdict(scan) | {
        "columns": columns,
        "seed": arguments.seed,
        "input_points": len(cloud),
        "output_points": count,
    }
    known = {}
    if arguments.keep_baselines:
        known = known_measurements(previous, experiment, arguments.methods)
    viewpoint = None
    if scan.views == 1:
        viewpoint = scene_tables.read_viewpoints(Path(f"{stem}_views.txt"))[0]
    cuts = [scan_pictures.parse_slice(text) for text in scan.slices.split(";")]
    measurements, pictures = {}, []
    for name in arguments.methods:
        if name in known:
            measurements[name] = known[name]
            continue
        measured, output, comparison = measure(bench, METHODS[name], stem, exact, count)
        measurements[name] = measured
        print(f"{scan.name}, {name}:", measured["measures"], file=sys.stderr, flush=True)
        if name in arguments.pictures:
            title = f"{scan.name}, {name}"
            pictures.append(scan_pictures.Row(title, cloud, output, comparison, viewpoint, cuts))
    return experiment | {"measurements": measurements}, pictures


def main():
    arguments = parse_arguments()
    scans = [scan for scan in SCANS if any(word in scan.name for word in arguments.only)]
    if arguments.small:
        scans = [SCANS[5], SCANS[7]]
    if not scans:
        raise ValueError("no scan has a name with " + " or ".join(arguments.only))
    command = command_line("run_scenes.py", sys.argv[1:])
    previous = earlier_run(arguments)
    commands, experiments = [command], {}
    if arguments.only != [""] or arguments.keep_baselines:
        commands = [old for old in previous["commands"] if old != command] + [command]
        experiments = {old["name"]: old for old in previous["experiments"]}
    pictures = []
    with tempfile.TemporaryDirectory() as scratch:
        bench = Bench(arguments.build / "bin", Path(scratch), 1)
        for scan in scans:
            experiments[scan.name], drawn = measure_scan(bench, scan, arguments, previous)
            pictures += drawn
            in_order = [experiments[one.name] for one in SCANS if one.name in experiments]
            result = {"commands": commands, "experiments": in_order}
            if arguments.output is not None:  # a long run that fails leaves what it has
                write_result(arguments.output, result, scene_tables.markdown(result))
    if arguments.output is None:
        write_result(None, result, scene_tables.markdown(result))
    elif pictures:
        scan_pictures.draw_page(arguments.output.with_suffix(".png"), pictures)


if __name__ == "__main__":
    try:
        main()
    except (ValueError, OSError, subprocess.CalledProcessError) as failure:
        sys.exit(f"run_scenes.py: {failure}")
