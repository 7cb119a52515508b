# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The page README.md can be typed from top to bottom in a clean clone, as a stranger would.

    test_readme.py SOURCE BUILD SCRATCH

SOURCE is the repository, BUILD a folder in which all is built, SCRATCH a folder for what is made.
Each command and each block of code of the page has its row in STEPS, in the order of the page: it
runs here, in a clone, or another test has it, or why it cannot run. Nothing is compiled here: in
scripts/run.sh the commands that compile and install do nothing, and the clone has the folder BUILD.
Whether that script would build what an install needs is asked of a clone that is only configured.
"""

import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

HERE = None
TESTS = "test/L0_resampling"


class OtherTest:
    """A test, and a text in one of its files which shows that it has the step."""

    def __init__(self, name, file, text):
        self.name, self.file, self.text = name, file, text

    def check(self, source):
        tiers = (source / TESTS / "tiers.csv").read_text()
        assert f"\n{self.name}," in tiers, f"no test {self.name}"
        assert self.text in (source / self.file).read_text(), f"{self.file} has no {self.text}"


PROJECT = OtherTest("install_and_consume", f"{TESTS}/packages/test_install.cmake",
                    "extract_readme_project.py ${SOURCE}/README.md")
PACKAGE = OtherTest("debian_package", f"{TESTS}/packages/test_package.cmake", "run(${CPACK} -G DEB")
STEPS = [
    ("scripts/run.sh", HERE),
    ("scripts/test.sh", "cannot run here: it runs this test"),
    ("build/bin/l0_resample scan.ply clean.ply --points 60000 --snapshot picture.png", HERE),
    ("build/bin/l0_resample scan.ply clean.ply --force --creases edges.obj", HERE),
    ("```cmake", PROJECT),
    ("```cpp", PROJECT),
    ("```python", OtherTest("test_python", f"{TESTS}/python/test_package.py",
                            "test_the_example_of_the_readme")),
    ("cmake --install build", HERE),
    ("scripts/package.sh", PACKAGE),   # but that it compiles once more
    ("sudo apt install ./build-package/cgal-l0-resampling_*.deb", PACKAGE),
    ("pip install .", OtherTest("test_wheel", f"{TESTS}/packages/test_wheel.py", "pip")),
    ("cmake --build build --target doc",
     OtherTest("documentation_builds", "doc/L0_resampling/documentation_builds.cmake",
               "--target doc")),
]


def steps_of(page):
    """Blocks of code, commands in blocks that are indented, and commands in sentences."""
    first_words = r"(?:scripts/\w+\.sh|build/bin/\w+|l0_resample|sudo|cmake|pip|benchmark/run\.sh)"
    code = r"^(```\w*)$.*?^```$"
    block = r"^    (\S[^\n]*)$"
    sentence = rf"`({first_words} [^`]+)`"
    found = re.finditer(f"{code}|{block}|{sentence}", page, re.MULTILINE | re.DOTALL)
    steps = [(match[1] or (match[2] or match[3]).split("#")[0].strip()) for match in found]
    return [step for step in steps if step != "l0_resample --help"]


def run(command, **options):
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                            check=False, **options)
    if result.returncode != 0:
        sys.exit(f"{command} ended with status {result.returncode}:\n{result.stdout}")
    return result.stdout


def build_of_run_script(source):
    """The arguments of CMake in scripts/run.sh: those that configure, and the targets."""
    script = (source / "scripts/run.sh").read_text().replace("\\\n", " ")
    configure = re.search(r"^cmake -S \. -B build (.*)$", script, re.MULTILINE)[1]
    targets = re.search(r"^cmake --build build .*--target (.*)$", script, re.MULTILINE)[1]
    return shlex.split(configure), targets.split()


def installed_files(build):
    """Files in the build folder that an install takes from there."""
    files = set()
    for script in build.rglob("cmake_install.cmake"):
        for call in re.findall(r"file\(INSTALL (.*?)\)", script.read_text(), re.DOTALL):
            if " OPTIONAL " not in call:
                files |= {p for p in re.findall(r'"(/[^"]+)"', call) if p.startswith(f"{build}/")}
    return {str(Path(path).relative_to(build)) for path in files}


def check_install_after_run_script(clone):
    options, targets = build_of_run_script(clone)
    build = clone / "build"
    run(["cmake", "-G", "Ninja", "-S", clone, "-B", build, *options])

    def needed_for(targets):
        graph = run(["ninja", "-C", build, "-t", "graph", *targets])
        return {os.path.relpath(os.path.join(build, path), build)
                for path in re.findall(r'label="([^" ]+)"', graph)}

    all_targets = needed_for(["all"])
    assert "bin/l0_resample" in all_targets, "ninja does not say what it would make"
    missing = sorted((installed_files(build) & all_targets) - needed_for(targets))
    assert not missing, f"scripts/run.sh does not build what `cmake --install` needs: {missing}"


def write_program(path, text):
    path.write_text(f"#!/bin/sh\n{text}\n")
    path.chmod(0o755)


def run_script(clone, scratch):
    """What scripts/run.sh does with what it has built, on small shapes in place of Debian's."""
    stubs = scratch / "stubs"
    stubs.mkdir()
    cmake = shutil.which("cmake")
    write_program(stubs / "cmake", 'case "$1" in -S | --build) exit 0 ;; esac\n'
                                   f'exec {shlex.quote(cmake)} "$@"')
    write_program(stubs / "dpkg-query", "echo installed")
    data = clone / "output/demo_data/data"
    for folder in ("points_3", "meshes"):
        (data / folder).mkdir(parents=True)
    for stand_in, name in (("torus_noisy.ply", "points_3/hippo1.ply"),
                           ("staircase_noisy.ply", "points_3/building.ply"),
                           ("bracket.off", "meshes/fandisk.off")):
        shutil.copy(clone / "data" / stand_in, data / name)
    text = run([clone / "scripts/run.sh"], cwd=clone,
               env={**os.environ, "PATH": f"{stubs}:{os.environ['PATH']}"})
    assert "Results, oriented points as PLY:" in text, text
    names = [f"{name}_resampled" for name in ("hippo", "building")]
    names += [f"fandisk_{method}" for method in ("default", "lor", "alor")]
    missing = [name for name in names if not (clone / f"output/{name}.ply").exists()]
    assert not missing, f"scripts/run.sh has not written {missing}"
    assert len(list((clone / "output").glob("*.png"))) == 11, "scripts/run.sh draws other pictures"


def main():
    source, build, scratch = (Path(argument).resolve() for argument in sys.argv[1:])
    steps = steps_of((source / "README.md").read_text(encoding="utf-8"))
    expected = [step for step, _ in STEPS]
    assert steps == expected, f"README.md has other steps: {steps}, not {expected}"
    for _, who in STEPS:
        if isinstance(who, OtherTest):
            who.check(source)

    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir(parents=True)
    clone = scratch / "clone"
    run(["git", "clone", "--quiet", "--no-hardlinks", source, clone])
    check_install_after_run_script(clone)
    shutil.rmtree(clone / "build")
    (clone / "build").symlink_to(build)
    shutil.copy(clone / "data/bracket_noisy.ply", clone / "scan.ply")
    for step, who in STEPS:
        if who is not HERE:
            continue
        if step == "scripts/run.sh":
            run_script(clone, scratch)
            continue
        if step.startswith("cmake --install"):
            step += " --prefix installed"
        run(["bash", "-c", step], cwd=clone)
    for name in ("clean.ply", "picture.png", "edges.obj", "installed/bin/l0_resample"):
        assert (clone / name).exists(), f"{name} is not there"


if __name__ == "__main__":
    main()
