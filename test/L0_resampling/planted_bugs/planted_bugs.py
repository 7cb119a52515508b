#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Plants bugs in a copy of the source tree and runs the tests that have to catch them.

  planted_bugs.py check            fails unless each row of the tables *.toml fits the source tree
  planted_bugs.py run [NAME...]    plants these bugs, or all of them, one at a time
  planted_bugs.py run --draw N     plants N of those that can be judged here, others for each commit

A table has rows

    [[bug]]
    name = "radius_rounded_down"
    test = "test_density_weights"
    about = "what the bug does, if its edit does not tell"
    file = "include/CGAL/L0_resampling/internal/search/ball_queries.h"
    find = 'std::ceil(radius / cell_size)'
    replace = 'std::floor(radius / cell_size)'

`find` has to occur once in its file; blanks, line breaks and comments do not matter (see
scripts/source_edits.py). `test` is a test of CTest, or a program of the build folder's bin/ with
its arguments; a list of several means that each of them has to fail. What a test runs is built
before it; `targets` names what else has to be. A test counts only if it runs and passes without the
bug. A bug that does not compile is not caught.
"""

import argparse
import csv
import os
import random
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parents[2]
sys.path.append(str(ROOT / "scripts"))
from source_edits import Applied, Edit_error, faults_of, read_rows

VERDICTS = HERE / "verdicts.csv"


def read_bugs():
    return [bug for path in sorted(HERE.glob("*.toml")) for bug in read_rows(path, "bug", ["test"])]


def tests_of(bug):
    tests = bug.fields["test"]
    return [tests] if isinstance(tests, str) else tests


class Scratch:
    """A copy of the source tree with a build folder of its own."""

    def __init__(self, folder, options, time_limit):
        self.tree, self.build, self.time_limit = folder / "tree", folder / "build", time_limit
        self.sound = {}    # whether a test passes without a bug, asked once a test
        ignored = shutil.ignore_patterns(".git", "build*", "output", "__pycache__")
        shutil.copytree(ROOT, self.tree, ignore=ignored)
        self.environment = dict(os.environ)
        launcher = []
        if shutil.which("ccache"):    # what one run compiles serves the next
            launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"]
            self.environment.update(CCACHE_BASEDIR=str(folder), CCACHE_NOHASHDIR="1")
        status, text = self.call("cmake", "-S", self.tree, "-B", self.build,
                                 "-DCMAKE_BUILD_TYPE=Release", "-DCGAL_L0_WITH_CUDA=OFF",
                                 *launcher, *options)
        if status != 0:
            raise Edit_error(f"CMake fails:\n{text}")
        listed = self.call("cmake", "--build", self.build, "--target", "help")[1]
        self.targets = set(re.findall(r"^\.\.\. ([\w+-]+)|^([\w+-]+): phony", listed, re.M))
        self.targets = {name for pair in self.targets for name in pair if name}
        self.lines_of_tests = [line for path in self.build.rglob("CTestTestfile.cmake")
                               for line in path.read_text(encoding="utf-8").splitlines()]

    def call(self, *command, time_limit=None):
        """The exit status and all that is printed; None for the status where time runs out."""
        try:
            done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE,
                                  stderr=subprocess.STDOUT, text=True, errors="replace",
                                  timeout=time_limit, env=self.environment)
            return done.returncode, done.stdout
        except subprocess.TimeoutExpired as error:
            return None, (error.stdout or b"").decode(errors="replace")

    def lines_of_test(self, test):
        """Of CMake's files, those that define the test and its properties."""
        start = re.compile(rf"(add_test|set_tests_properties)\((\[=\[)?{re.escape(test)}(\]=\])? ")
        return [line for line in self.lines_of_tests if start.match(line)]

    def targets_of(self, test):
        words = re.findall(rf'{re.escape(str(self.build))}/([^"\s;]*)',
                           " ".join(self.lines_of_test(test))) or [test.split()[0]]
        return sorted({Path(word).name for word in words} & self.targets)

    def builds(self, test, targets):
        targets = [*self.targets_of(test), *targets]
        if not targets:
            raise Edit_error(f"what {test} runs is no target; name it in `targets`")
        return self.call("cmake", "--build", self.build, "--target", *targets)[0] == 0

    def run(self, test):
        if self.lines_of_test(test):
            return self.call("ctest", "--test-dir", self.build, "-R", f"^{re.escape(test)}$",
                             "--output-on-failure", "--timeout", self.time_limit)
        program, *arguments = shlex.split(test)
        return self.call(self.build / "bin" / program, *arguments, time_limit=self.time_limit)

    def is_sound(self, test, targets):
        if test not in self.sound:
            status, text = self.run(test) if self.builds(test, targets) else (None, "")
            self.sound[test] = status == 0 and "***Skipped" not in text
        return self.sound[test]

    def verdict(self, bug):
        """A sentence that begins with "caught" if all tests of the bug fail with it."""
        targets, words = bug.fields.get("targets", []), []
        for test in tests_of(bug):
            if not self.is_sound(test, targets):
                return f"cannot be judged: {test} fails without it"
        with Applied(self.tree, bug):
            for test in tests_of(bug):
                if not self.builds(test, targets):
                    return "does not build"
                status, text = self.run(test)
                if status == 0:
                    return f"NOT CAUGHT by {test}"
                failed = re.search(r"failed: .*", text)
                how = failed.group()[:90] if failed else "it ends with an error"
                words.append(f"{test} ({how})")
        return f"caught by {', '.join(words)}"


def record(name, verdict, code):
    """Puts a line into the table of verdicts, in place of the bug's earlier one."""
    verdicts = {}
    if VERDICTS.exists():
        with open(VERDICTS, encoding="utf-8", newline="") as stream:
            verdicts = {row["bug"]: row for row in csv.DictReader(stream)}
    verdicts[name] = {"bug": name, "code": code, "verdict": verdict.partition(" by ")[0]}
    known = {bug.name for bug in read_bugs()}
    with open(VERDICTS, "w", encoding="utf-8", newline="") as stream:
        writer = csv.DictWriter(stream, ["bug", "code", "verdict"], lineterminator="\n")
        writer.writeheader()
        writer.writerows(verdicts[bug] for bug in sorted(verdicts) if bug in known)


def run(bugs, arguments):
    commit = subprocess.run(["git", "-C", ROOT, "rev-parse", "--short", "HEAD"], text=True,
                            stdout=subprocess.PIPE).stdout.strip() or "unknown"
    if arguments.draw is not None:
        bugs = random.Random(commit).sample(bugs, len(bugs))
    planted, missed = 0, 0
    with tempfile.TemporaryDirectory() as folder:
        scratch = Scratch(Path(folder), arguments.cmake, arguments.time_limit)
        for bug in bugs:
            if planted == arguments.draw:
                break
            try:
                verdict = scratch.verdict(bug)
            except Edit_error as error:
                verdict = f"cannot be planted: {error}"
            print(f"{bug.name}: {verdict}", flush=True)
            if arguments.draw is not None and verdict.startswith("cannot be"):
                continue
            planted += 1
            missed += not verdict.startswith("caught")
            if arguments.record:
                record(bug.name, verdict, commit)
    print(f"{planted} planted, {missed} not caught")
    return 1 if missed or planted == 0 else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("action", choices=["check", "run"])
    parser.add_argument("names", nargs="*", metavar="NAME", help="bugs to plant; else all")
    parser.add_argument("--cmake", action="append", default=[], metavar="OPTION",
                        help="for CMake, such as --cmake=-DCMAKE_CXX_FLAGS_RELEASE=-O1")
    parser.add_argument("--time-limit", type=int, default=600, metavar="SECONDS",
                        help="a test that takes longer has caught a hang")
    parser.add_argument("--draw", type=int, metavar="N", help="plant so many of the bugs")
    parser.add_argument("--record", action="store_true", help="put the verdicts into verdicts.csv")
    arguments = parser.parse_intermixed_args()

    bugs = read_bugs()
    if arguments.action == "check":
        faults = list(faults_of(ROOT, bugs))
        print("\n".join([*faults, f"{len(bugs)} bugs, {len(faults)} faults"]))
        return 1 if faults or not bugs else 0
    unknown = set(arguments.names) - {bug.name for bug in bugs}
    if unknown:
        parser.error(f"there is no bug {', '.join(sorted(unknown))}")
    chosen = [bug for bug in bugs if not arguments.names or bug.name in arguments.names]
    return run(chosen, arguments)


if __name__ == "__main__":
    try:
        sys.exit(main())
    except (Edit_error, OSError) as error:
        sys.exit(f"planted_bugs.py: {error}")
