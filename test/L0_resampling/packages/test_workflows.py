#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""The workflows of GitHub, as far as can be said without it: test_workflows.py SOURCE_DIRECTORY

Each is YAML with the keys that a workflow needs and no others, and the scripts that it runs are
there and can be run. So is the one that pyproject.toml names for cibuildwheel.
"""

import os
import re
import sys
import tomllib
from pathlib import Path

try:
    import yaml
except ImportError:
    print("PyYAML is not there.")
    sys.exit(77)

KEYS = {"workflow": ({"name", "on", "jobs"}, {"permissions", "env", "concurrency"}),
        "job": ({"runs-on", "steps"}, {"name", "container", "timeout-minutes", "env", "needs",
                                       "strategy", "if"}),
        "step": (set(), {"name", "run", "uses", "with", "env", "shell", "if"})}
EVENTS = {"push", "pull_request", "workflow_dispatch", "schedule", "release"}

source = Path(sys.argv[1])
failures = []


def check_keys(where, kind, mapping):
    if not isinstance(mapping, dict):
        failures.append(f"{where} is no mapping")
        return {}
    needed, allowed = KEYS[kind]
    # YAML 1.1 reads the word "on" as a truth value.
    keys = {"on" if key is True else key for key in mapping}
    failures.extend(f"{where} has no {key}" for key in sorted(needed - keys))
    failures.extend(f"{where} has {key}, which is no key of a {kind}"
                    for key in sorted(keys - needed - allowed))
    return mapping


def check_step(where, step):
    check_keys(where, "step", step)
    if ("run" in step) == ("uses" in step):
        failures.append(f"{where} needs either run or uses")
    if not re.fullmatch(r"[\w.-]+/[\w./-]+@v?[\w.]+", step.get("uses", "a/b@v1")):
        failures.append(f"{where} uses {step['uses']}, which has no version")
    for script in re.findall(r"(?<![\w/])scripts/[\w./-]+", step.get("run", "")):
        if not os.access(source / script, os.X_OK):
            failures.append(f"{where} runs {script}, which cannot be run")


paths = sorted((source / ".github/workflows").glob("*.yml"))
if not paths:
    failures.append("there are no workflows")
for path in paths:
    try:
        workflow = yaml.safe_load(path.read_text(encoding="utf-8"))
    except yaml.YAMLError as error:
        failures.append(f"{path.name}: {error}")
        continue
    check_keys(path.name, "workflow", workflow)
    events = workflow.get(True, [])
    failures.extend(f"{path.name}: there is no event {event}" for event in set(events) - EVENTS)
    for name, job in workflow.get("jobs", {}).items():
        check_keys(f"{path.name}, {name}", "job", job)
        for number, step in enumerate(job.get("steps", []), 1):
            check_step(f"{path.name}, {name}, step {number}", step)
with open(source / "pyproject.toml", "rb") as stream:
    cibuildwheel = tomllib.load(stream)["tool"]["cibuildwheel"]
if not os.access(source / cibuildwheel["before-all"], os.X_OK):
    failures.append(f"pyproject.toml names {cibuildwheel['before-all']}, which cannot be run")
sys.exit("\n".join(failures) or 0)
