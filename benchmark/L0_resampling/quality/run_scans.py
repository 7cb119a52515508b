#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Resamples the scans of a folder, measures what is lost and invented, and draws pictures of all.

There is no truth to compare with. Distances are compared with the local spacing, which is the mean
distance to six neighbors, of the scan:

  lost     share of the scan's points that are farther than 3 spacings from the result
  ghosts   share of the result that is farther than 2 spacings from the scan
  adrift   share of the result that is farther than 1.5 spacings from the scan
  box      diagonal of the box of the inner 99 % of each coordinate, over the scan's
  uneven   variation of the result's spacing against that of the twelve points around
  thin     where the result is less dense than the scan: the 5 % quantile of its density over the
           scan's, if both had as many points
  dense    where it is denser: the 95 % quantile
  away     share of normals that face away from the viewpoint by more than 10 degrees
  up       share of the near-vertical normals that point upwards, where they all should
  plane    mean angle of the normals on a flat part, in degrees

For lost points and ghosts the spacing is at least the median spacing of the result. An even result
has points adrift wherever it fills the gaps between the rings of a scanner.

The table has a row for each scan and method, and with --output FOLDER/NAME.png a row of pictures. A
table of options, by default scans.csv in FOLDER or beside this program, has the columns scan,
viewpoint, up, plane_low, plane_high, plane_tolerance and slices. Vectors are written as 0,0,1.
Slices are written as in 'z 1.3 0.2; x 0 0.1 4 5 2': axis, position and thickness, and optionally
center and size of a window in the other two coordinates.
"""

import argparse
import csv
import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

try:
    import numpy

    import scan_measures
    import scan_pictures
except ImportError as error:
    print(f"skipped: {error}; Debian has it as python3-numpy, python3-scipy or python3-matplotlib")
    sys.exit(77)

from quality_bench import command_line, write_result
from quality_tables import table

sys.path.append(str(Path(__file__).resolve().parents[1] / "methods"))
from methods import ear, simple_filter, wlop

BUILD = Path(__file__).resolve().parents[3] / "build"
OURS = {"default": [], "keep_density": ["--keep-density"]}
RIVALS = {
    "wlop_4": wlop(4),
    "wlop_4_uniform": wlop(4, "--require-uniform-sampling"),
    "ear_4": ear(4),
    "smoothed_ear_4": ear(4, "first"),
    "jet_24": simple_filter("jet", "--neighbors", 24),
    "bilateral_60": simple_filter("bilateral", "--neighbors", 60),
}
DIGITS = {
    "lost": 2,
    "ghosts": 2,
    "adrift": 2,
    "box": 3,
    "uneven": 3,
    "thin": 2,
    "dense": 2,
    "away": 2,
    "up": 1,
    "plane": 1,
    "seconds": 1,
}


def parse_vector(text):
    vector = numpy.array([float(number) for number in text.split(",")])
    if len(vector) != 3:
        raise ValueError(f"'{text}' is not a vector such as 0,0,1")
    return vector


def read_options(path):
    """From the name of a scan to its row of the table, without empty fields."""
    if not path.exists():
        return {}
    with open(path, newline="", encoding="utf-8") as stream:
        return {
            row["scan"]: {key: value for key, value in row.items() if value}
            for row in csv.DictReader(stream)
        }


def scans_of(folder, only):
    """From the names of the scans to their files; points compressed with xz too."""
    files = sorted(path for path in folder.iterdir() if path.name.endswith((".ply", ".ply.xz")))
    return {path.name.split(".ply")[0]: path for path in files if only in path.name}


def unpacked(path, scratch):
    if path.suffix != ".xz":
        return path
    source = scratch / path.stem
    source.write_bytes(scan_measures.lzma.open(path).read())
    return source


def hints(tool, options):
    """Options for orientation that this version of the tool has."""
    known = subprocess.run([tool, "--help"], check=True, capture_output=True, text=True).stdout
    return [
        word
        for name in ("viewpoint", "up")
        if name in options and f"--{name}" in known
        for word in (f"--{name}", options[name])
    ]


def resample(build, source, result, method, count, options, extra):
    """Raises CalledProcessError where the method fails."""
    result.unlink(missing_ok=True)
    if method in OURS:
        tool = build / "bin/l0_resample"
        command = [
            tool,
            source,
            result,
            "--points",
            count,
            "--quiet",
            *OURS[method],
            *hints(tool, options),
            *extra,
        ]
    else:
        rival = RIVALS[method]
        command = [build / "bin" / rival.program, source, result, "--points", count, *rival.options]
    subprocess.run([str(word) for word in command], check=True, stdout=subprocess.DEVNULL)


def measure(scan, result, comparison, options):
    measures = comparison.measures()
    if "viewpoint" in options:
        measures["away"] = scan_measures.away_from_viewpoint(
            result, parse_vector(options["viewpoint"])
        )
    if "up" in options:
        measures["up"] = scan_measures.turned_up(result)
    if "plane_low" in options:
        box = parse_vector(options["plane_low"]), parse_vector(options["plane_high"])
        measures["plane"] = scan_measures.angle_to_plane(
            scan.positions, result, *box, float(options["plane_tolerance"])
        )
    return measures


def markdown(result):
    columns = [name for name in DIGITS if any(name in row["measures"] for row in result["rows"])]
    cells = [
        [
            row["scan"],
            row["method"],
            str(row["points"]),
            *(
                f"{row['measures'][name]:.{DIGITS[name]}f}" if name in row["measures"] else "-"
                for name in columns
            ),
        ]
        for row in result["rows"]
    ]
    commands = "".join(f"    {command}\n" for command in result["commands"])
    return (
        f"# Scans\n\nMade by\n\n{commands}\nPoints are those of the scan, of which the result has "
        f"{result['percentage']:g} %. Shares are in percent, `plane` in degrees.\n\n"
        + table(["scan", "method", "points", *columns], cells)
    )


def parse_arguments():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument(
        "folder", type=Path, help="has the scans, *.ply and *.ply.xz, binary little-endian"
    )
    parser.add_argument(
        "--build", type=Path, default=BUILD, help="build folder; its bin/ has the programs"
    )
    parser.add_argument(
        "--output",
        type=Path,
        metavar="FOLDER/NAME",
        help="what to write, see common/results.py; else the table is printed",
    )
    parser.add_argument("--table", type=Path, help="options of the scans, a CSV file")
    parser.add_argument("--methods", nargs="+", choices=[*OURS, *RIVALS], default=[*OURS])
    parser.add_argument("--only", default="", help="scans whose file name has this")
    parser.add_argument(
        "--percentage",
        type=float,
        default=50,
        help="points of the result, in percent of the scan's",
    )
    parser.add_argument(
        "--extra",
        nargs=argparse.REMAINDER,
        default=[],
        help="further options of l0_resample; comes last",
    )
    arguments = parser.parse_args()
    if arguments.table is None:
        own = arguments.folder / "scans.csv"
        arguments.table = own if own.exists() else Path(__file__).with_name("scans.csv")
    return arguments


def main():
    arguments = parse_arguments()
    options_of = read_options(arguments.table)
    scans = scans_of(arguments.folder, arguments.only)
    if not scans:
        raise ValueError(f"{arguments.folder} has no scan")
    result = {
        "commands": [command_line("run_scans.py", sys.argv[1:])],
        "percentage": arguments.percentage,
        "rows": [],
    }
    pictures = []
    with tempfile.TemporaryDirectory() as folder:
        scratch = Path(folder)
        for name, path in scans.items():
            scan, source, options = (
                scan_measures.read_cloud(path),
                unpacked(path, scratch),
                options_of.get(name, {}),
            )
            count = max(1, round(len(scan) * arguments.percentage / 100))
            for method in arguments.methods:
                target = scratch / f"{name}_result.ply"
                start = time.monotonic()
                resample(arguments.build, source, target, method, count, options, arguments.extra)
                seconds = time.monotonic() - start
                cloud = scan_measures.read_cloud(target)
                comparison = scan_measures.Comparison(scan.positions, cloud.positions)
                measures = measure(scan, cloud, comparison, options) | {"seconds": seconds}
                result["rows"].append(
                    {"scan": name, "method": method, "points": len(scan), "measures": measures}
                )
                print(
                    name,
                    method,
                    *(f"{key} {value:.3g}" for key, value in measures.items()),
                    file=sys.stderr,
                    flush=True,
                )
                viewpoint = parse_vector(options["viewpoint"]) if "viewpoint" in options else None
                cuts = [
                    scan_pictures.parse_slice(text)
                    for text in options.get("slices", "").split(";")
                    if text.strip()
                ]
                pictures.append(
                    scan_pictures.Row(f"{name}, {method}", scan, cloud, comparison, viewpoint, cuts)
                )
    write_result(arguments.output, result, markdown(result))
    if arguments.output is not None:
        scan_pictures.draw_page(arguments.output.with_suffix(".png"), pictures)


if __name__ == "__main__":
    try:
        main()
    except (ValueError, OSError, subprocess.CalledProcessError) as failure:
        sys.exit(f"run_scans.py: {failure}")
