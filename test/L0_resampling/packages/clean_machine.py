#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Programs of a machine on which nothing is installed yet but compilers and libraries, for
test_readme.py. Each is a link to this file, in a folder that is the first of PATH.

CMake configures, but finds Doxygen only once it was installed. In place of compiling, it takes what
the targets make, if there are such targets, from the folder L0_BUILT in which all is built. APT
installs names, into a list that dpkg-query reads. CTest counts the tests, and CPack and lintian see
whether what they are given is there.
"""

import glob
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

PROGRAMS = ("cmake", "ctest", "cpack", "lintian", "dpkg-query", "apt-get", "apt", "sudo")
HERE = Path(sys.argv[0]).absolute().parent
INSTALLED = HERE / "installed_packages"
# Of what these bring, that which is looked for in PATH. CMake asks Doxygen for its version and for
# a file.
BROUGHT = {"doxygen": ("doxygen", '[ "$1" = --version ] && echo 1.9.4 || touch "$3"'),
           "texlive-binaries": ("bibtex", "exit 1")}
OPTIONS_OF_BUILD = ("CGAL_L0_WITH_CUDA", "CGAL_L0_WITH_NATIVE_INSTRUCTIONS")


def make(folder, built):
    """The programs in a folder; returns the environment to run them in."""
    folder.mkdir()
    for name in PROGRAMS:
        (folder / name).symlink_to(Path(__file__).resolve())
    environment = {**os.environ, "PATH": f"{folder}:{os.environ['PATH']}",
                   "L0_PATH": os.environ["PATH"], "L0_BUILT": str(built),
                   "CMAKE_GENERATOR": "Ninja"}
    environment.pop("PYTHONPATH", None)
    return environment


def real(name, *arguments):
    """The status of the program that stands behind these."""
    return subprocess.run([shutil.which(name, path=os.environ["L0_PATH"]), *arguments],
                          check=False).returncode


def installed():
    return INSTALLED.read_text().split() if INSTALLED.exists() else []


def configure(arguments):
    cache = (Path(os.environ["L0_BUILT"]) / "CMakeCache.txt").read_text()
    of_build = [f"-D{name}={value}" for name in OPTIONS_OF_BUILD
                for value in re.findall(rf"^{name}:BOOL=(.*)$", cache, re.MULTILINE)]
    is_there = "doxygen" in installed()
    # Without run paths, an install edits none, of programs that were linked in another folder.
    return real("cmake", *arguments, *of_build, "-DCMAKE_SKIP_RPATH=ON",
                f"-DCMAKE_DISABLE_FIND_PACKAGE_Doxygen={'OFF' if is_there else 'ON'}")


def compile_targets(folder, targets):
    built = Path(os.environ["L0_BUILT"])
    graph = subprocess.run(["ninja", "-C", folder, "-t", "graph", *targets], text=True, check=False,
                           stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if graph.returncode != 0:
        sys.exit(f"cmake --build {folder}: {graph.stdout.splitlines()[-1]}")
    for label in re.findall(r'label="([^" ]+)"', graph.stdout):
        path = Path(os.path.relpath(Path(folder, label), folder))
        source, target = built / path, Path(folder, path)
        if ".." in path.parts or path.suffix == ".o" or target.exists() or not source.is_file():
            continue
        target.parent.mkdir(parents=True, exist_ok=True)
        try:
            os.link(source.resolve(), target)
        except OSError:   # on another disk
            shutil.copy(source, target)


def cmake(arguments):
    if arguments[0] == "-S":
        return configure(arguments)
    if arguments[0] != "--build":
        return real("cmake", *arguments)
    targets = []
    if "--target" in arguments:
        targets = arguments[arguments.index("--target") + 1:]
    compile_targets(arguments[1], targets or ["all"])
    return 0


def ctest(arguments):
    return real("ctest", "-N", "--quiet", *arguments)


def cpack(arguments):
    folder = Path(arguments[arguments.index("-B") + 1])
    if not Path(arguments[arguments.index("--config") + 1]).exists():
        return 1
    (folder / "cgal-l0-resampling_0_all.deb").touch()
    return 0


def lintian(arguments):
    return 0 if glob.glob(arguments[-1]) else 1


def dpkg_query(arguments):
    is_there = arguments[-1] in installed()
    print("installed" if is_there else "", end="")
    return 0 if is_there else 1


def apt(arguments):
    if "install" not in arguments:
        return 0
    names = [name for name in arguments[arguments.index("install"):][1:] if name[0] != "-"]
    for name in names:
        if "/" in name and not Path(name).is_file():
            return 100
        program, text = BROUGHT.get(name, (None, None))
        if program:
            (HERE / program).write_text(f"#!/bin/sh\n{text}\n")
            (HERE / program).chmod(0o755)
    INSTALLED.write_text("\n".join([*installed(), *names]))
    return 0


def sudo(arguments):
    os.execvp(arguments[0], arguments)


def main():
    name = Path(sys.argv[0]).name.replace("-", "_")
    functions = {"apt_get": apt, "apt": apt, "cmake": cmake, "ctest": ctest, "cpack": cpack,
                 "lintian": lintian, "dpkg_query": dpkg_query, "sudo": sudo}
    sys.exit(functions[name](sys.argv[1:]))


if __name__ == "__main__":
    main()
