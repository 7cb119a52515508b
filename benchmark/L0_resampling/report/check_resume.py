#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Interrupts a run of the report and checks that --resume measures what is missing and nothing else: check_resume.py BUILD REPORT SCRATCH

REPORT is the output of a finished run of the selection tiny; it stays as it is. Times tell what was measured again, since no two are equal.
"""

import json
import shutil
import subprocess
import sys
from pathlib import Path

SKIPPED = 77
MISSING = "LOR"    # the row of Fig. 1 that the interrupted run did not come to


def run(build, output, experiment, *options):
    """The whole report, and what it has of one experiment."""
    program = Path(__file__).resolve().parent / "make_report.py"
    status = subprocess.run([sys.executable, "-B", program, build, output, "--selection", "tiny", "--only", experiment, *options]).returncode
    if status == SKIPPED:
        sys.exit(SKIPPED)
    assert status == 0, f"make_report.py ends with {status}"
    result = json.loads((output / "report.json").read_text(encoding="utf-8"))
    return result, result["experiments"][experiment]


def main():
    build, finished, output = map(Path, sys.argv[1:])
    if not (finished / "report.json").exists():
        print("skipped: there is no report")
        return SKIPPED
    shutil.rmtree(output, ignore_errors=True)
    shutil.copytree(finished, output)
    before = json.loads((output / "report.json").read_text(encoding="utf-8"))
    measured = before["experiments"].pop("comparisons")[0]["measurements"]
    (output / "report.json").write_text(json.dumps(before), encoding="utf-8")
    (output / "files" / f"fig_1_{MISSING}.json").unlink()

    result, comparisons = run(build, output, "comparisons", "--resume")
    resumed = comparisons[0]["measurements"]
    for name, row in measured.items():
        assert name == MISSING or resumed[name] == row, f"{name} was measured again"
    assert resumed[MISSING]["wall_seconds"] != measured[MISSING]["wall_seconds"], f"{MISSING} was not measured"
    assert resumed[MISSING]["evaluation"] == measured[MISSING]["evaluation"], f"{MISSING} is another one"
    assert result["experiments"]["table_1"] == before["experiments"]["table_1"], "another experiment has changed"
    assert result["seconds"]["comparisons"] > before["seconds"]["comparisons"], "the seconds before the interruption are lost"

    # What was kept for another question is no answer to this one.
    kept = output / "files" / "fig_1_default.json"
    other = json.loads(kept.read_text(encoding="utf-8"))
    other["asked"][2][0]["seed"] += 1
    kept.write_text(json.dumps(other), encoding="utf-8")
    _, comparisons = run(build, output, "comparisons", "--resume")
    assert comparisons[0]["measurements"]["default"]["wall_seconds"] != measured["default"]["wall_seconds"], "a measurement of another input was taken"

    studies = before["experiments"]["interleaving"]["studies"]
    _, again = run(build, output, "interleaving")
    assert all(a["wall_seconds"] != b["wall_seconds"] for a, b in zip(again["studies"], studies)), "without --resume, an earlier measurement was taken"
    print(f"{len(measured) - 1} rows were kept, {MISSING} measured")
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except AssertionError as error:
        sys.exit(f"check_resume.py: {error}")
