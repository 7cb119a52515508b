# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The commands of README.md can be typed one after the other, as a stranger would.

    test_readme.py SOURCE BUILD SCRATCH

SOURCE is the repository, BUILD a folder in which all is built, SCRATCH a folder for what is made.
Each command of the page has its row in COMMANDS, in the order of the page: what runs it. Nothing is
compiled here: after scripts/run.sh, an install has to find all of its files, and whether it does is
asked of a clone that is only configured: do the targets of that script make them?
"""

import os
import re
import shlex
import shutil
import subprocess
import sys
from pathlib import Path

HERE, OTHER_TEST, BY_HAND = "here", "another test", "by hand"

# scripts/run.sh is looked at in build_of_run_script(); another test has the rest of it in its name
COMMANDS = [
    ("scripts/run.sh", HERE),
    ("scripts/test.sh", BY_HAND),   # it runs this test
    ("build/bin/l0_resample scan.ply clean.ply --points 60000 --snapshot picture.png", HERE),
    ("build/bin/l0_resample scan.ply clean.ply --force --creases edges.obj", HERE),
    ("cmake --install build", HERE),
    ("scripts/package.sh", OTHER_TEST),   # debian_package
    ("sudo apt install ./build-package/cgal-l0-resampling_*.deb", OTHER_TEST),
    ("pip install .", OTHER_TEST),   # test_wheel
    ("cmake --build build --target doc", OTHER_TEST),   # documentation_builds
]


def commands_of(page):
    """Those in blocks of the page that are indented, and those in its sentences."""
    page = re.sub(r"^```.*?^```$", "", page, flags=re.MULTILINE | re.DOTALL)
    first_words = r"(?:scripts/\w+\.sh|build/bin/\w+|l0_resample|sudo|cmake|pip|benchmark/run\.sh)"
    block = rf"^    ({first_words}.*)$"
    sentence = rf"`({first_words} [^`]+)`"
    found = re.finditer(rf"{block}|{sentence}", page, re.MULTILINE)
    commands = [(match[1] or match[2]).split("#")[0].strip() for match in found]
    return [c for c in commands if c != "l0_resample --help"]


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


def check_install_after_run_script(source, scratch):
    clone = scratch / "clone"
    run(["git", "clone", "--quiet", "--no-hardlinks", source, clone])
    options, targets = build_of_run_script(source)
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


def main():
    source, build, scratch = (Path(argument).resolve() for argument in sys.argv[1:])
    commands = commands_of((source / "README.md").read_text(encoding="utf-8"))
    expected = [command for command, _ in COMMANDS]
    assert commands == expected, f"README.md has other commands: {commands}, not {expected}"

    shutil.rmtree(scratch, ignore_errors=True)
    scratch.mkdir(parents=True)
    check_install_after_run_script(source, scratch)
    folder = scratch / "stranger"
    folder.mkdir()
    (folder / "build").symlink_to(build)
    shutil.copy(source / "data/bracket_noisy.ply", folder / "scan.ply")
    environment = {**os.environ, "PATH": f"{build / 'bin'}:{os.environ['PATH']}"}
    for command, who in COMMANDS:
        if who != HERE or command == "scripts/run.sh":
            continue
        if command.startswith("cmake --install"):
            command += " --prefix installed"
        run(["bash", "-c", command], cwd=folder, env=environment)
    for name in ("clean.ply", "picture.png", "installed/bin/l0_resample"):
        assert (folder / name).exists(), f"{name} is not there"


if __name__ == "__main__":
    main()
