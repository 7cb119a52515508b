#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reproduces the paper's tables and figures, with every method that it names, and writes OUTPUT/report.{json,md,html}.

The page is one file: tables, plots, and clouds and meshes that can be turned. `--page-only` makes it anew from the files
of an earlier run.
"""

import argparse
import json
import os
import subprocess
import sys
import time
from pathlib import Path

from selections import SELECTIONS

try:
    import experiments
    import sections
    from laboratory import Laboratory
except ImportError as error:
    print(f"skipped: {error}; Debian has it as python3-numpy, python3-matplotlib or python3-jinja2")
    sys.exit(77)

sys.path += [str(Path(__file__).resolve().parents[1] / folder) for folder in ("common", "performance", "quality")]
from quality_bench import command_line
from results import write_json
from run_performance import machine

EXPERIMENTS = ("table_1", "equations", "half_sampling", "interleaving", "normal_weights", "comparisons", "thin_plate", "scans",
               "noise", "device_runs")


def measure(arguments, files, report):
    """Runs the experiments, and writes the JSON after each, so that what a long run has is not lost.

    `--only` and `--resume` add to the report of an earlier run, if there is one.
    """
    selection = SELECTIONS[arguments.selection]
    lab = Laboratory(arguments.build, files, arguments.demo_data, arguments.jobs, selection.picture_triangles, arguments.resume)
    result = {"commands": [], "selection": selection.name, "machine": machine(arguments.build), "seconds": {}, "experiments": {}}
    if (arguments.only or arguments.resume) and report.with_suffix(".json").exists():
        result = json.loads(report.with_suffix(".json").read_text(encoding="utf-8"))
        if result["selection"] != selection.name:
            raise ValueError(f"the earlier run was of the selection {result['selection']}")
    result["commands"].append(command_line("make_report.py", sys.argv[1:]))
    try:
        for name in arguments.only or EXPERIMENTS:
            start = time.monotonic()
            earlier = result["seconds"].get(name, 0) if arguments.resume else 0
            try:
                result["experiments"][name] = getattr(experiments, name)(lab, selection)
            finally:
                result["seconds"][name] = earlier + time.monotonic() - start
                write_json(report.with_suffix(".json"), result)
    finally:
        lab.pool.shutdown(cancel_futures=True)    # where one program fails, others need not begin
    return result


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path, help="build folder; its bin/ has the programs")
    parser.add_argument("output", type=Path, help="folder to write; the clouds and meshes of the pictures go to OUTPUT/files")
    parser.add_argument("--selection", choices=SELECTIONS, default="small")
    parser.add_argument("--demo-data", type=Path, help="the data folder of libcgal-demo; without it, our own shapes")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), help="programs run beside each other, but where time is measured")
    parser.add_argument("--only", nargs="+", choices=EXPERIMENTS, help="runs these; others are in the report if OUTPUT/report.json has them")
    parser.add_argument("--resume", action="store_true", help="what an interrupted run of the same programs has measured is not measured again")
    parser.add_argument("--page-only", action="store_true")
    return parser.parse_args()


def main():
    arguments = parse_arguments()
    if not sections.THREE.exists():
        print("skipped: needs Debian's libjs-three")
        return 77
    files = arguments.output / "files"
    files.mkdir(parents=True, exist_ok=True)
    report = arguments.output / "report"
    if arguments.page_only:
        result = json.loads(report.with_suffix(".json").read_text(encoding="utf-8"))
    else:
        result = measure(arguments, files, report)
    parts = sections.all_sections(result)
    report.with_suffix(".md").write_text(sections.markdown(parts), encoding="utf-8")
    report.with_suffix(".html").write_text(sections.page(parts, files), encoding="utf-8")
    print(report.with_suffix(".html"))
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (ValueError, OSError, subprocess.CalledProcessError) as error:
        sys.exit(f"make_report.py: {error}")
