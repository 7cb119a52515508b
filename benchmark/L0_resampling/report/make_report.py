#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reproduces the paper's tables and figures, as far as they can be measured, with every method that
it names, and says which of the paper's sentences hold. Writes OUTPUT/report.{json,md}."""

import argparse
import json
import os
import subprocess
import sys
import time
from pathlib import Path

import experiments
import sections
from laboratory import Laboratory
from selections import SELECTIONS

HERE = Path(__file__).resolve().parent
sys.path += [str(HERE.parent / folder) for folder in ("common", "performance", "quality")]
from quality_bench import command_line
from results import write_json
from run_performance import machine

EXPERIMENTS = [make.__name__ for make in sections.SECTIONS]


def measure(arguments, files, report):
    """Runs the experiments, and writes the JSON after each, so that what a long run has is not
    lost. `--only` adds to the report of an earlier run, if there is one."""
    selection = SELECTIONS[arguments.selection]
    lab = Laboratory(arguments.build, files, arguments.demo_data, arguments.jobs)
    result = {"commands": [], "selection": selection.name, "machine": machine(arguments.build),
              "seconds": {}, "experiments": {}}
    if arguments.only and report.with_suffix(".json").exists():
        result = json.loads(report.with_suffix(".json").read_text(encoding="utf-8"))
        if result["selection"] != selection.name:
            raise ValueError(f"the earlier run was of the selection {result['selection']}")
    result["commands"].append(command_line("make_report.py", sys.argv[1:]))
    try:
        for name in arguments.only or EXPERIMENTS:
            start = time.monotonic()
            result["experiments"][name] = getattr(experiments, name)(lab, selection)
            result["seconds"][name] = time.monotonic() - start
            write_json(report.with_suffix(".json"), result)
    finally:
        lab.pool.shutdown(cancel_futures=True)    # where one program fails, others need not begin
    return result


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path, help="build folder; its bin/ has the programs")
    parser.add_argument("output", type=Path,
                        help="folder to write; clouds and meshes go to OUTPUT/files")
    parser.add_argument("--selection", choices=SELECTIONS, default="full")
    parser.add_argument("--demo-data", type=Path,
                        help="the data folder of libcgal-demo; without it, our own shapes")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(),
                        help="programs run beside each other, but where time is measured")
    parser.add_argument("--only", nargs="+", choices=EXPERIMENTS,
                        help="runs these; others are in the report if OUTPUT/report.json has them")
    arguments = parser.parse_args()
    files, report = arguments.output / "files", arguments.output / "report"
    files.mkdir(parents=True, exist_ok=True)
    text = sections.markdown(measure(arguments, files, report))
    report.with_suffix(".md").write_text(text, encoding="utf-8")
    print(report.with_suffix(".md"))


if __name__ == "__main__":
    try:
        main()
    except (ValueError, OSError, subprocess.CalledProcessError) as error:
        sys.exit(f"make_report.py: {error}")
