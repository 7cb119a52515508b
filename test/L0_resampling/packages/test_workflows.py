#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""The workflows of GitHub, as far as can be said without it: test_workflows.py SOURCE_DIRECTORY

Each is YAML that workflow.schema.json allows, and the scripts that it runs are there and can be
run. So is the one that pyproject.toml names for cibuildwheel.
"""

import copy
import json
import os
import re
import sys
import tomllib
from pathlib import Path

try:
    import jsonschema
    import yaml
except ImportError as error:
    print(f"{error.name} is not there.")
    sys.exit(77)

source = Path(sys.argv[1])
schema = json.loads(Path(__file__).with_name("workflow.schema.json").read_text(encoding="utf-8"))
jsonschema.Draft7Validator.check_schema(schema)
validator = jsonschema.Draft7Validator(schema)
failures = []


def read_workflow(path):
    workflow = yaml.safe_load(path.read_text(encoding="utf-8"))
    if isinstance(workflow, dict) and True in workflow:  # YAML 1.1 reads "on" as a truth value.
        workflow["on"] = workflow.pop(True)
    return workflow


def check_scripts(where, workflow):
    for job in workflow["jobs"].values():
        for step in job["steps"]:
            for script in re.findall(r"(?<![\w/])scripts/[\w./-]+", step.get("run", "")):
                if not os.access(source / script, os.X_OK):
                    failures.append(f"{where} runs {script}, which cannot be run")


def check_that_faults_are_found(workflow):
    """The schema refuses what a slip of the pen would make of a workflow that it allows."""
    job = next(iter(workflow["jobs"]))
    for keys, value in [(("on",), ["pushes"]), (("on",), []),
                        (("permissions", "contents"), "maybe"), (("jobs", job, "runs-on"), []),
                        (("jobs", job, "runs-on"), "linux"),
                        (("jobs", job, "timeout-minutes"), "soon"), (("jobs", job, "steps"), []),
                        (("jobs", job, "step"), []), (("jobs", job, "steps", 0), {"name": "none"}),
                        (("jobs", job, "steps", 0), {"uses": "a/b@v1", "with": {"path": []}}),
                        (("jobs", job, "steps", 0), {"run": "true", "shell": "zsh"}),
                        (("jobs", job, "steps", 0), {"uses": "actions/checkout"}),
                        (("jobs", job, "steps", 0), {"uses": "a/b@v1", "run": "true"})]:
        faulty = copy.deepcopy(workflow)
        place = faulty
        for key in keys[:-1]:
            place = place[key]
        place[keys[-1]] = value
        if validator.is_valid(faulty):
            failures.append(f"the schema allows {value!r} for {keys}")


paths = sorted((source / ".github/workflows").glob("*.yml"))
if not paths:
    failures.append("there are no workflows")
for path in paths:
    try:
        workflow = read_workflow(path)
    except yaml.YAMLError as error:
        failures.append(f"{path.name}: {error}")
        continue
    faults = [f"{path.name}: {'/'.join(map(str, error.absolute_path))}: {error.message}"
              for error in validator.iter_errors(workflow)]
    failures.extend(faults)
    if not faults:
        check_scripts(path.name, workflow)
        check_that_faults_are_found(workflow)
with open(source / "pyproject.toml", "rb") as stream:
    cibuildwheel = tomllib.load(stream)["tool"]["cibuildwheel"]
if not os.access(source / cibuildwheel["before-all"], os.X_OK):
    failures.append(f"pyproject.toml names {cibuildwheel['before-all']}, which cannot be run")
sys.exit("\n".join(failures) or 0)
