#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures how long `pip install .` takes for the commit that is checked out, in an environment
that has the packages of the system, without a package index. Fewer cores than the machine has:
`taskset -c 0,1 run_install.py`."""

import argparse
import os
import resource
import subprocess
import sys
import tempfile
import time
import venv
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[1] / "common"))
from results import processor, write_result

ROOT = Path(__file__).resolve().parents[3]


def run(*command, **options):
    return subprocess.run([str(word) for word in command], check=True, stdout=subprocess.PIPE,
                          **options).stdout


def measure(scratch):
    source, environment = scratch / "source", scratch / "environment"
    source.mkdir()
    run("tar", "-x", "-C", source, input=run("git", "-C", ROOT, "archive", "HEAD"))
    venv.create(environment, system_site_packages=True)
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    start = time.monotonic()
    # By the pip of the system, as an environment need not have one of its own
    run(sys.executable, "-m", "pip", "--python", environment / "bin/python", "install", source,
        "--no-build-isolation", "--no-deps", "--no-index", "--no-cache-dir",
        env={"CMAKE_BUILD_PARALLEL_LEVEL": str(len(os.sched_getaffinity(0))), **os.environ})
    seconds = time.monotonic() - start
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    run(environment / "bin/python", "-B", "-c", "import cgal_l0", cwd=scratch)
    return {"cores": len(os.sched_getaffinity(0)), "seconds": seconds,
            "cpu_seconds": after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime,
            "megabytes": after.ru_maxrss / 1024}


def markdown(result):
    return f"""# Time of pip install

Made by `run_install.py` at commit `{result['commit']}` on {result['processor']}, load average before:
{result['load']:.1f}. Memory is that of the largest process.

| cores | seconds | CPU seconds | MB |
| ---: | ---: | ---: | ---: |
| {result['cores']} | {result['seconds']:.0f} | {result['cpu_seconds']:.0f} | {result['megabytes']:.0f} |
"""


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--output", type=Path, metavar="FOLDER/NAME", help="see common/results.py")
    parser.add_argument("--at-most", type=float, metavar="SECONDS",
                        help="ends with status 1 if it takes longer")
    arguments = parser.parse_args()
    result = {"processor": processor(), "load": os.getloadavg()[0],
              "commit": run("git", "-C", ROOT, "rev-parse", "--short=7", "HEAD").decode().strip()}
    with tempfile.TemporaryDirectory() as scratch:
        result |= measure(Path(scratch))
    write_result(arguments.output, result, markdown(result))
    if arguments.at_most is not None and result["seconds"] > arguments.at_most:
        sys.exit(f"pip install took {result['seconds']:.0f} s, and may take {arguments.at_most:.0f} s.")


if __name__ == "__main__":
    main()
