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
    ("l0_resample --info scan.ply", HERE),
    ("l0_resample scans/*.ply --output-directory out", HERE),
    ("l0_resample city/*.las --as-one --memory 16GB --output-directory out", HERE),
    ("l0_resample --convert-only scan.pcd converted.ply", HERE),
    ("l0_resample survey.las ground.las --keep-classes 2", HERE),
    ("cmake --install build", HERE),
    ("scripts/package.sh", OTHER_TEST),   # debian_package
    ("sudo apt install ./build-package/cgal-l0-resampling_*.deb", OTHER_TEST),
    ("cmake --build build --target doc", OTHER_TEST),   # documentation_builds
    ("pip install .", OTHER_TEST),   # test_wheel
    ("benchmark/run.sh", BY_HAND),   # it takes minutes
    ("benchmark/run.sh --full", BY_HAND),
    ("build/bin/stream_scene scan.las --points 1000000000 --blocks 250 --block 0-249 "
     "--stations stations.txt", HERE),
    ("measure_in_scene clean.ply --points 1000000000", HERE),
]


def commands_of(page):
    """Those in blocks of the page that are indented, and those in its sentences."""
    page = page.split("\n## Where is what")[0]
    page = re.sub(r"^```.*?^```$", "", page, flags=re.MULTILINE | re.DOTALL)
    first_words = r"(?:scripts/\w+\.sh|build/bin/\w+|l0_resample|sudo|cmake|pip|benchmark/run\.sh"
    first_words += r"|measure_in_scene)"
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


def make_scans(source, tool, folder):
    """Small files of the names that the page has."""
    scan = source / "data/bracket_noisy.ply"
    shutil.copy(scan, folder / "scan.ply")
    for name in ("scans/a.ply", "scans/b.ply", "city/a.las", "city/b.las", "scan.pcd",
                 "survey.las"):
        (folder / name).parent.mkdir(exist_ok=True)
        run([tool, "--convert-only", scan, folder / name])


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
    make_scans(source, build / "bin/l0_resample", folder)
    environment = {**os.environ, "PATH": f"{build / 'bin'}:{os.environ['PATH']}"}
    for command, who in COMMANDS:
        if who != HERE or command == "scripts/run.sh":
            continue
        command = command.replace("1000000000", "20000").replace(" 0-249", " 0-3")
        if command.startswith("cmake --install"):
            command += " --prefix installed"
        run(["bash", "-c", command], cwd=folder, env=environment)
    for name in ("clean.ply", "picture.png", "out/a.ply", "out/tile_0.ply", "converted.ply",
                 "ground.las", "installed/bin/l0_resample", "stations.txt"):
        assert (folder / name).exists(), f"{name} is not there"


if __name__ == "__main__":
    main()
