# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The page README.md can be typed from top to bottom in a clean clone, as a stranger would.

    test_readme.py SOURCE BUILD SCRATCH

SOURCE is the repository, BUILD a folder in which all is built, SCRATCH a folder for what is made.
Each command and each block of code of the page has its row in STEPS, in the order of the page. It
runs here, in one clone and its build folder, on a machine that has no Doxygen (clean_machine.py),
or a test that is named runs it. CMake configures, but nothing is compiled: what targets make comes
from BUILD.
"""

import importlib.util
import os
import re
import shutil
import subprocess
import sys
import venv
from dataclasses import dataclass
from pathlib import Path

import clean_machine

TESTS = "test/L0_resampling"
DOCUMENTATION = "doc/L0_resampling"
BENCHMARKS = "benchmark/L0_resampling"


@dataclass(frozen=True)
class OtherTest:
    """A test, and a text in one of its files which shows that it has the step."""
    name: str
    file: str
    text: str

    def check(self, source):
        tests = run(["git", "-C", source, "grep", "-hF", f"NAME {self.name}", "--",
                     "*CMakeLists.txt"]).split()
        assert self.name in tests, f"no test {self.name}"
        assert self.text in (source / self.file).read_text(), f"{self.file} has no {self.text}"


@dataclass(frozen=True)
class Step:
    """A step, and the test that does what is not done here."""
    text: str
    other: OtherTest = None
    runs_here: bool = True


PROJECT = OtherTest("install_and_consume", f"{TESTS}/packages/test_install.cmake",
                    "extract_readme_project.py ${SOURCE}/README.md")
PYTHON = OtherTest("test_python", f"{TESTS}/python/test_package.py",
                   "test_the_example_of_the_readme")
PACKAGE = OtherTest("debian_package", f"{TESTS}/packages/test_package.cmake", "run(${CPACK} -G DEB")
STEPS = [
    Step("benchmark/run.sh", OtherTest("benchmark_report_tiny",
                                       f"{BENCHMARKS}/report/CMakeLists.txt", "make_report.py")),
    Step("scripts/run.sh"),
    Step("scripts/test.sh"),   # but for the tests, of which this is one
    Step("l0_resample --help"),
    Step("build/bin/l0_resample scan.ply clean.ply --points 60000 --snapshot picture.png"),
    Step("build/bin/l0_resample scan.ply clean.ply --force --creases edges.obj"),
    Step("```cmake", PROJECT, runs_here=False),
    Step("```cpp", PROJECT, runs_here=False),
    Step("```python", PYTHON, runs_here=False),
    Step("cmake --install build"),
    Step("scripts/package.sh", PACKAGE),
    Step("sudo apt install ./build-package/cgal-l0-resampling_*.deb", PACKAGE),
    Step("pip install .", OtherTest("test_wheel", f"{TESTS}/packages/test_wheel.py", '"wheel"')),
    Step("scripts/manual.sh", OtherTest("documentation_builds",
                                        f"{DOCUMENTATION}/documentation_builds.cmake",
                                        "--target doc")),
]


def is_command(text, source):
    """Of what stands in a sentence: whether it is no name, but can be typed."""
    first, *others = text.split()
    program = source / first
    is_in_tree = program.is_file() and os.access(program, os.X_OK)
    return is_in_tree or (others and first[0] != "-") or shutil.which(first) is not None


def steps_of(page, source):
    """Blocks of code, commands in blocks that are indented, and commands in sentences."""
    code = r"^(```\w*)$.*?^```$"
    block = r"^    (\S[^\n]*)$"
    sentence = r"`([^`]+)`"
    for match in re.finditer(f"{code}|{block}|{sentence}", page, re.MULTILINE | re.DOTALL):
        if match[3] is None:
            yield match[1] or match[2].split("#")[0].strip()
        elif is_command(match[3], source):
            yield " ".join(match[3].split())


def run(command, **options):
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                            check=False, **options)
    if result.returncode != 0:
        sys.exit(f"{command} ended with status {result.returncode}:\n{result.stdout}")
    return result.stdout


def prepare(clone):
    """Small shapes in place of Debian's and of a scan, a tenth of the points in scripts/run.sh, and
    of the report on the paper what needs none of its programs."""
    data = clone / "output/demo_data/data"
    for folder in ("points_3", "meshes"):
        (data / folder).mkdir(parents=True)
    for stand_in, name in (("torus_noisy.ply", "points_3/hippo1.ply"),
                           ("staircase_noisy.ply", "points_3/building.ply"),
                           ("bracket.off", "meshes/fandisk.off")):
        shutil.copy(clone / "data" / stand_in, data / name)
    shutil.copy(clone / "data/bracket_noisy.ply", clone / "scan.ply")
    script = clone / "scripts/run.sh"
    script.write_text(re.sub(r"(--points \d+)0\b", r"\1", script.read_text()))
    script = clone / BENCHMARKS / "report/make_report.py"
    script = script.rename(script.with_name("make_whole_report.py"))
    script.with_name("make_report.py").write_text(
        "import runpy, sys\n"
        "sys.argv += ['--selection', 'tiny', '--only', 'device_runs']\n"
        f"runpy.run_path({str(script)!r}, run_name='__main__')\n")


def environment_of_pip(machine, scratch, environment):
    """That of a virtual environment, without a network; none where pip is not there."""
    if not all(importlib.util.find_spec(name) for name in ("setuptools", "wheel", "pip")):
        return None
    folder = scratch / "environment"
    venv.create(folder, system_site_packages=True, with_pip=False)
    pip = machine / "pip"
    pip.write_text(f'#!/bin/sh\nexec {sys.executable} -m pip --python {folder}/bin/python "$@"\n')
    pip.chmod(0o755)
    # Pip reads "0" of an option that begins with "no" as "no".
    return {**environment, "PIP_NO_INDEX": "1", "PIP_NO_DEPS": "1", "PIP_NO_BUILD_ISOLATION": "0",
            "PIP_NO_CACHE_DIR": "1", "PIP_DISABLE_PIP_VERSION_CHECK": "1"}


def check_results(clone, installed):
    names = ["clean.ply", "picture.png", "edges.obj", "output/benchmark/report.md"]
    names += [f"output/{name}_resampled.ply" for name in ("hippo", "building")]
    names += [f"output/fandisk_{method}.ply" for method in ("default", "lor", "alor")]
    missing = [name for name in names if not (clone / name).exists()]
    assert not missing, f"README.md's steps have not written {missing}"
    assert len(list((clone / "output").glob("*.png"))) == 11, "scripts/run.sh draws other pictures"
    assert list(installed.rglob("bin/l0_resample")), "l0_resample is not installed"


def main():
    source, build, scratch = (Path(argument).resolve() for argument in sys.argv[1:])
    page = (source / "README.md").read_text(encoding="utf-8")
    steps, expected = list(steps_of(page, source)), [step.text for step in STEPS]
    assert steps == expected, f"README.md has other steps: {steps}, not {expected}"
    for step in STEPS:
        if step.other:
            step.other.check(source)

    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir(parents=True)
    clone, machine, installed = scratch / "clone", scratch / "machine", scratch / "installed"
    run(["git", "clone", "--quiet", "--no-hardlinks", source, clone])
    prepare(clone)
    environment = clean_machine.make(machine, build)
    for step in STEPS:
        of_step = environment
        if step.text.startswith("l0_resample"):
            of_step = {**environment, "PATH": f"{clone}/build/bin:{environment['PATH']}"}
        if step.text.startswith("cmake --install"):
            of_step = {**environment, "DESTDIR": str(installed)}
        if step.text.startswith("pip"):
            of_step = environment_of_pip(machine, scratch, environment)
        if step.runs_here and of_step is not None:
            run(["bash", "-c", step.text], cwd=clone, env=of_step)
    check_results(clone, installed)


if __name__ == "__main__":
    main()
