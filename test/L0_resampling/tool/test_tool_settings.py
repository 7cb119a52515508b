#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Each option of l0_resample is told to whom its result matters:

  test_tool_settings.py PROGRAM

One that results depend on is in the report of a run and in the key of a run by tiles, which refuses
to go on with another value of it. Others are in neither. Each option that has a range refuses what
is not in it. A new option has to be added to a table here.
"""

import json
import os
import random
import subprocess
import sys
import tempfile
from pathlib import Path

program = Path(sys.argv[1]).resolve()

# Options that results depend on, with another value than the one without them; None for a flag
OF_RESULTS = {
    "output-format": "xyz", "points": "50", "percentage": "40", "keep-density": None,
    "source-index": None, "feature-confidence": None, "side-confidence": None,
    "point-radius": None, "point-noise": None, "point-deviation": None, "creases": "creases.obj",
    "input-format": "csv", "columns": "x,y,z", "decimal-comma": None, "allow-degrees": None,
    "drop-non-finite": None, "keep-classes": "2,6", "first-returns": None, "decompress": "cat {}",
    "keep-outliers": None, "outlier-sensitivity": "2", "outliers": "outliers.xyz",
    "method": "lor", "neighbor-radius": "0.3", "noise": "0.01", "noise-property": "accuracy",
    "normal-weight": "0.5", "sharpness-angle": "20", "seed": "1", "solver": "cholesky",
    "solver-iterations": "50", "use-normals": None, "orient-by-normals": None,
    "viewpoint": "0,0,9", "viewpoints": "views.xyz", "view-property": "view", "up": "0,0,1",
    "device": "auto", "memory": "2GB", "halo": "30", "orient-only": None}
# Options that no result depends on
OF_NO_RESULT = {
    "force": None, "page": "page.html", "snapshot": "picture.png", "view": "1,2,3",
    "snapshot-views": "2", "snapshot-colors": "normals", "quiet": None, "strict": None,
    "threads": "1", "max-points": "1000", "max-memory": "4GB", "timeout": "100",
    "config": "empty.txt"}
# Options that choose what is done, so that there is nothing to compare
OF_TASK = {"output", "output-directory", "as-one", "json", "resume", "info", "dry-run",
           "convert-only", "help", "version"}
# What has to stand beside an option
BESIDE = {"view-property": ["--viewpoints", "views.xyz"]}
for picture in ["view", "snapshot-views", "snapshot-colors"]:
    BESIDE[picture] = ["--snapshot", "picture.png"]
# Values out of the range of an option
WRONG = {
    "output-format": "doc", "points": "0", "percentage": "-1", "input-format": "doc",
    "columns": "x,y", "keep-classes": "300", "decompress": "cat", "outlier-sensitivity": "4",
    "method": "best", "neighbor-radius": "0", "noise": "nan", "normal-weight": "-1",
    "sharpness-angle": "91", "seed": "-1", "solver": "magic", "solver-iterations": "0",
    "viewpoint": "1,2", "up": "0,0,0", "view": "0,0,0", "snapshot-views": "5",
    "snapshot-colors": "red", "device": "tpu", "threads": "0", "max-points": "-1",
    "max-memory": "much", "memory": "much", "halo": "0.5", "timeout": "0"}
# Types of values that have no range
FREE_TYPES = {"FILE", "FILE.png", "FILE.html", "FOLDER", "OUTPUT", "NAME"}
# Options that need --as-one
OF_TILES = {"memory", "halo"}
# What another parameter of the report says then
FOLLOWS = {"viewpoint": {"outwards_assumed"}, "viewpoints": {"outwards_assumed"},
           "up": {"outwards_assumed"}, "orient-by-normals": {"outwards_assumed"},
           "points": {"percentage"}}
# What a run by tiles says instead of the option: the format of each file, and nothing of a device,
# which has to be there for another key
NOT_NAMED = {"input-format": ": csv, ", "device": None}
# What no result depends on, and a report has all the same
REPORTED = {"threads"}

ALONE = ["cloud.xyz", "out.ply", "--force", "--json", "report.json", "--device", "cpu"]
TILES = ["cloud.xyz", "--as-one", "--output-directory", "tiles", "--memory", "1GB"]

failures = []


def check(what, is_good):
    if not is_good:
        failures.append(what)


def run(words):
    return subprocess.run([program, *words], stdin=subprocess.DEVNULL, capture_output=True,
                          text=True, check=False)


def with_option(words, name, value):
    """The words with the option, in place of the value that it has there."""
    option = "--" + name
    words = words + BESIDE.get(name, [])
    if option not in words:
        return words + [option] + ([] if value is None else [value])
    if value is None:
        return words
    place = words.index(option) + 1
    return words[:place] + [value] + words[place + 1:]


def options_of_help():
    """The type of the value of each option, None for a flag."""
    types = {}
    for line in run(["--help"]).stdout.splitlines():
        words = line[:33].split()
        if line.startswith(" ") and words[0].startswith("-"):
            long_name = next(word for word in words if word.startswith("--"))
            types[long_name[2:]] = None if words[-1] == long_name else words[-1]
    return types


def parameters(words, name):
    """Those of the report, with what it tells of the option elsewhere; None if the command line is
    refused."""
    report = Path("report.json")
    report.unlink(missing_ok=True)
    status = run(words).returncode
    if status == 2:
        return None
    told = json.loads(report.read_text())
    if name == "neighbor-radius":   # of which it has the one in effect
        told["parameters"]["neighbor_radius"] = told["resampling"]["neighbor_radius"]
    return told["parameters"]


def check_report(name, value):
    """Whether the report tells of the option."""
    plain = parameters(ALONE + BESIDE.get(name, []), name)
    toggled = parameters(with_option(ALONE, name, value), name)
    if toggled is None:
        check(f"--{name} without --as-one", name in OF_TILES)
        return False
    key = name.replace("-", "_")
    changed = {k for k in plain.keys() | toggled.keys() if plain.get(k) != toggled.get(k)}
    if name in OF_RESULTS or name in REPORTED:
        check(f"the report has {key}, and nothing else for it: {changed}",
              key in changed and changed <= {key} | FOLLOWS.get(name, set()))
    else:
        check(f"no parameter for --{name}: {changed}", not changed)
    return key in changed


def check_key(name, value):
    """Whether a run by tiles refuses to go on with another value."""
    outcome = run(with_option(TILES, name, value) + ["--resume", "--task", "begin"])
    if "excludes" in outcome.stderr or (name in NOT_NAMED and NOT_NAMED[name] is None):
        return False
    if name in OF_NO_RESULT:
        check(f"--resume goes on with another --{name}: {outcome.stderr}", outcome.returncode == 0)
        return False
    named = NOT_NAMED.get(name, "--" + name)
    begin = "l0_resample: --resume: the run began with "
    check(f"--resume refuses another --{name}: {outcome.stderr}",
          outcome.returncode in (2, 3) and outcome.stderr.startswith(begin)
          and named in outcome.stderr.partition(", now it is ")[2])
    return True


def check_wrong_value(name):
    words = TILES if name in OF_TILES else ALONE
    outcome = run(with_option(words, name, WRONG[name]))
    check(f"--{name} refuses {WRONG[name]}: {outcome.stderr}",
          outcome.returncode == 2 and "--" + name in outcome.stderr
          and WRONG[name] in outcome.stderr)


def check_all():
    random.seed(1)
    with open("cloud.xyz", "w") as cloud:
        for i in range(300):   # of a box
            point = [random.random(), random.random(), random.random()]
            point[i % 3] = i // 3 % 2
            print(*point, file=cloud)
    Path("views.xyz").write_text("0 0 9\n")
    Path("empty.txt").touch()

    types = options_of_help()
    known = OF_RESULTS.keys() | OF_NO_RESULT.keys() | OF_TASK
    check(f"options that no table here has: {types.keys() - known}", known >= types.keys())
    check(f"options that are no more: {known - types.keys()}", known <= types.keys())
    with_range = {name for name, of_value in types.items() if of_value not in FREE_TYPES | {None}}
    check(f"options with a range and without a wrong value, or the other way around:"
          f" {with_range ^ WRONG.keys()}", with_range == WRONG.keys())

    check("a run by tiles begins", run(TILES + ["--task", "begin"]).returncode == 0)
    check("and goes on", run(TILES + ["--resume", "--task", "begin"]).returncode == 0)
    for name, value in (OF_RESULTS | OF_NO_RESULT).items():
        told = [check_report(name, value), check_key(name, value)]
        check(f"report or key tells of --{name}", any(told) or name in OF_NO_RESULT)
    check_key("viewpoint", "none")   # which is neither a place nor nothing
    for name in WRONG:
        check_wrong_value(name)


with tempfile.TemporaryDirectory() as folder:
    os.chdir(folder)
    check_all()
    os.chdir("/")
for failure in failures:
    print("failed:", failure, file=sys.stderr)
sys.exit(1 if failures else 0)
