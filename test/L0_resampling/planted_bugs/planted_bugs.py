#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plants bugs in a copy of the source tree and runs the tests that have to catch them.

  planted_bugs.py check          fails unless each row of planted_bugs.toml fits the source tree
  planted_bugs.py run [NAME...]  plants these bugs, or all of them, one at a time

The table has rows

    [[bug]]
    name = "radius_rounded_down"
    test = "test_density_weights"
    about = "what the bug does, if its edit does not tell"
    file = "include/CGAL/L0_resampling/internal/search/ball_queries.h"
    find = 'std::ceil(radius / cell_size)'
    replace = 'std::floor(radius / cell_size)'

`find` has to occur once in its file; blanks, line breaks and comments do not matter (see
scripts/source_edits.py). `test` is a test of CTest. What it runs is built before it; `targets`
names what else has to be. A test counts only if it runs and passes without the bug. A bug that does
not compile is not caught.
"""

import argparse
import os
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path.append(str(ROOT / "scripts"))
from source_edits import Applied, Edit_error, faults_of, read_rows

# One library for tests, tool and Python module, compiled at -O1 as the tests are. Most bugs lie in
# headers: precompiled, these would be compiled once more for each.
OPTIONS = ("-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG",
           "-DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON", "-DCGAL_L0_WITH_CUDA=OFF",
           "-DCGAL_L0_WITH_NATIVE_INSTRUCTIONS=OFF", "-DCGAL_L0_HAS_X86_64_V4=OFF")


def read_bugs():
    return read_rows(HERE / "planted_bugs.toml", "bug", ["test"])


class Scratch:
    """A copy of the source tree with a build folder of its own."""

    def __init__(self, folder, options, time_limit):
        self.tree, self.build, self.time_limit = folder / "tree", folder / "build", time_limit
        ignored = shutil.ignore_patterns(".git", "build*", "output", "__pycache__")
        shutil.copytree(ROOT, self.tree, ignore=ignored)
        status, text = self.call("cmake", "-S", self.tree, "-B", self.build, *OPTIONS, *options)
        if status != 0:
            raise Edit_error(f"CMake fails:\n{text}")
        listed = self.call("ninja", "-C", self.build, "-t", "targets", "all")[1]
        self.targets = set(re.findall(r"^([\w+-]+): phony", listed, re.M))
        self.lines_of_tests = [line for path in self.build.rglob("CTestTestfile.cmake")
                               for line in path.read_text(encoding="utf-8").splitlines()]

    def call(self, *command):
        """The exit status and all that is printed."""
        done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, errors="replace",
                              env={**os.environ, "PYTEST_ADDOPTS": "--exitfirst"})
        return done.returncode, done.stdout

    def targets_of(self, bug):
        """What the test of the bug runs, by the lines of CMake's files that define the test."""
        start = re.compile(r'(add_test|set_tests_properties)\((\[=\[|")?'
                           + re.escape(bug.fields["test"]) + r'(\]=\]|")? ')
        lines = " ".join(line for line in self.lines_of_tests if start.match(line))
        words = re.findall(rf'{re.escape(str(self.build))}/([^"\s;]*)', lines)
        named = {Path(word).name for word in words} & self.targets
        return named.union(bug.fields.get("targets", []))

    def builds(self, targets):
        """Whether all of them are built; those that can be are, in any case."""
        return not targets or self.call("ninja", "-C", self.build, "-j", 1, "-k", 0,
                                        *sorted(targets))[0] == 0

    def run(self, test):
        """Whether CTest runs this test and it passes, and what is printed."""
        status, text = self.call("ctest", "--test-dir", self.build, "-R", f"^{re.escape(test)}$",
                                 "--no-tests=error", "--output-on-failure",
                                 "--timeout", self.time_limit)
        return status == 0 and "***Skipped" not in text, text

    def verdict(self, bug):
        """A sentence that begins with "caught" if the test of the bug fails with it."""
        with Applied(self.tree, bug):
            if not self.builds(self.targets_of(bug)):
                return "does not build"
            passes, text = self.run(bug.fields["test"])
        if passes:
            return f"NOT CAUGHT by {bug.fields['test']}"
        failed = re.search(r"failed: .*", text)
        how = failed.group()[:90] if failed else "it ends with an error"
        return f"caught by {bug.fields['test']} ({how})"


def number_of_missed(bugs, folder, arguments):
    """Prints a verdict on each bug, and says how many of them are not caught."""
    scratch = Scratch(folder, arguments.cmake, arguments.time_limit)
    scratch.builds(set().union(*(scratch.targets_of(bug) for bug in bugs)))
    passes = {test: scratch.run(test)[0] for test in {bug.fields["test"] for bug in bugs}}
    missed = 0
    # In the order of their files, as what a bug in a header has had compiled is compiled anew for
    # the next one that is to be caught by such a program.
    for bug in sorted(bugs, key=lambda bug: bug.edits[0].file):
        test = bug.fields["test"]
        verdict = (scratch.verdict(bug) if passes[test]
                   else f"cannot be judged: {test} fails without it")
        sys.stdout.write(f"{bug.name}: {verdict}\n")
        sys.stdout.flush()
        missed += not verdict.startswith("caught")
    return missed


def run(bugs, arguments):
    """Most programs are one source file, so that two copies of the tree take half of the time."""
    tests = sorted({bug.fields["test"] for bug in bugs})
    shares = {}
    for bug in bugs:
        shares.setdefault(tests.index(bug.fields["test"]) % arguments.jobs, []).append(bug)
    with tempfile.TemporaryDirectory() as folder, ThreadPoolExecutor(len(shares)) as pool:
        missed = sum(pool.map(lambda share: number_of_missed(shares[share],
                                                             Path(folder) / str(share), arguments),
                              shares))
    print(f"{len(bugs)} bugs, {missed} not caught")
    return 1 if missed else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("action", choices=["check", "run"])
    parser.add_argument("names", nargs="*", metavar="NAME", help="bugs to plant; else all")
    parser.add_argument("--cmake", action="append", default=[], metavar="OPTION",
                        help="for CMake, such as --cmake=-DPython_EXECUTABLE=/usr/bin/python3")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(), metavar="N",
                        help="copies of the tree, in each of which one process compiles")
    parser.add_argument("--time-limit", type=int, default=600, metavar="SECONDS",
                        help="a test that takes longer has caught a hang")
    arguments = parser.parse_intermixed_args()

    bugs = read_bugs()
    if arguments.action == "check":
        faults = list(faults_of(ROOT, bugs))
        print("\n".join([*faults, f"{len(bugs)} bugs, {len(faults)} faults"]))
        return 1 if faults or not bugs else 0
    unknown = set(arguments.names) - {bug.name for bug in bugs}
    if unknown:
        parser.error(f"there is no bug {', '.join(sorted(unknown))}")
    return run([bug for bug in bugs if not arguments.names or bug.name in arguments.names],
               arguments)


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (Edit_error, OSError) as error:
        sys.exit(f"planted_bugs.py: {error}")
