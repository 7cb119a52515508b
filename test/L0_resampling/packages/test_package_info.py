#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""What CGAL is told of the package, against the headers:

  test_package_info.py SOURCE_DIRECTORY COMPILER INCLUDE_DIRECTORY...

SOURCE_DIRECTORY is that of the project, or the package's folder in a tree of CGAL. The packages of
CGAL that the headers depend on, directly or not, are those in the file of dependencies. Each header
of CGAL says in its line $URL$ which package it is of. The header of the license warns or refuses as
those of CGAL's packages do.
"""

import re
import subprocess
import sys
from pathlib import Path

OWN_LICENSE = "/CGAL/license/L0_resampling.h"   # in a tree: beside those of all packages

source, compiler, *folders = sys.argv[1:]
command = [compiler, "-std=c++17", f"-I{source}/include", *(f"-I{folder}" for folder in folders),
           "-DCGAL_EIGEN3_ENABLED", "-DCGAL_LINKED_WITH_TBB"]


def compiled(text, *options):
    return subprocess.run([*command, *options, "-x", "c++", "-"], input=text, text=True,
                          capture_output=True, check=False)


def dependencies():
    include = Path(source, "include")
    headers = [path for path in sorted(include.rglob("*.h")) if "internal" not in path.parts
               and "CUDA" not in path.name and path.name != "named_parameters_interface.h"]
    text = "".join(f"#include <{path.relative_to(include)}>\n" for path in headers)
    rule = compiled(text, "-M")
    if rule.returncode != 0:
        sys.exit(rule.stderr)
    packages = {"L0_resampling"}
    for name in rule.stdout.replace("\\\n", " ").split():
        if "/CGAL/" not in name or name.startswith(f"{include}/") or name.endswith(OWN_LICENSE):
            continue
        package = re.search(r"\$URL: \S*/blob/[^/\s]+/([^/\s]+)/include/",
                            Path(name).read_text(encoding="utf-8", errors="replace"))
        if package is None:
            sys.exit(f"{name} does not say which package it is of")
        packages.add(package[1])
    return sorted(packages)


failures = []
written = Path(source, "package_info/L0_resampling/dependencies").read_text(encoding="utf-8")
needed = dependencies()
if written.split() != needed:
    failures.append(f"the dependencies are {' '.join(needed)}, not {' '.join(written.split())}")

LICENSE = "-DCGAL_L0_RESAMPLING_COMMERCIAL_LICENSE"
for options, returncode, sentence in [
        ([], 0, ""),
        (["-DCGAL_LICENSE_WARNING"], 0, "is under the GPL, version 3 or later"),
        (["-DCGAL_LICENSE_ERROR"], 1, "is under the GPL, version 3 or later"),
        (["-DCGAL_LICENSE_WARNING", f"{LICENSE}=20991231"], 0, ""),
        (["-DCGAL_LICENSE_ERROR", f"{LICENSE}=20991231"], 0, ""),
        (["-DCGAL_LICENSE_WARNING", f"{LICENSE}=20111231"], 0, "younger than what your license"),
        (["-DCGAL_LICENSE_ERROR", f"{LICENSE}=20111231"], 1, "younger than what your license")]:
    answer = compiled("#include <CGAL/license/L0_resampling.h>\n", "-fsyntax-only", *options)
    if answer.returncode != returncode or sentence not in answer.stderr \
            or (not sentence and answer.stderr):
        failures.append(f"{' '.join(options)}: {answer.returncode}, {answer.stderr}")
sys.exit("\n".join(failures) or 0)
