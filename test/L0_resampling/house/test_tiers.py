#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Each test of CTest has one row of tiers.csv, and the label of its tier:

  test_tiers.py CTEST BUILD_DIRECTORY [TIER]

A build of all that TIER has, and of no more, has no test of a later tier, and a test for each row
of its tiers but those for which something may be missing.
"""

import csv
import json
import subprocess
import sys
from fnmatch import fnmatchcase
from pathlib import Path

TABLE = Path(__file__).resolve().parents[1] / "tiers.csv"
TIERS = ["core", "user", "full"]
CONDITION = "only where there is"


def tests_of(ctest, build):
    """The labels of each test."""
    answer = subprocess.run([ctest, "--test-dir", build, "--show-only=json-v1"], check=True,
                            stdout=subprocess.PIPE, text=True).stdout
    return {test["name"]: [label for entry in test.get("properties", [])
                           if entry["name"] == "LABELS" for label in entry["value"]]
            for test in json.loads(answer)["tests"]}


def faults_of_table(rows):
    for row in rows:
        if row["tier"] not in TIERS or not row["reason"] or None in row:
            yield f"the row {row} needs a test, a tier of {TIERS}, a condition or none, a reason"


def faults_of_tests(rows, tests):
    for test, labels in tests.items():
        tiers = [row["tier"] for row in rows if fnmatchcase(test, row["test"])]
        if len(tiers) != 1:
            yield f"{test} has {len(tiers)} rows"
        elif [label for label in labels if label in TIERS] != tiers:
            yield f"{test} has the labels {labels}, and not {tiers[0]}"


def faults_of_build(rows, tests, tier):
    expected = TIERS[:TIERS.index(tier) + 1]
    for row in rows:
        found = [test for test in tests if fnmatchcase(test, row["test"])]
        if row["tier"] not in expected and found:
            yield f"{found} of the tier {row['tier']} are no tests of {tier}"
        if row["tier"] in expected and not found and not row[CONDITION]:
            yield f"there is no test {row['test']}"


def main():
    ctest, build, *tier = sys.argv[1:]
    with open(TABLE, encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream))
    tests = tests_of(ctest, build)
    faults = [*faults_of_table(rows), *faults_of_tests(rows, tests)]
    for name in tier:
        faults += faults_of_build(rows, tests, name)
    print("\n".join([*faults, f"{len(rows)} rows, {len(tests)} tests, {len(faults)} faults"]))
    return 1 if faults or not tests else 0


if __name__ == "__main__":
    sys.exit(main())
