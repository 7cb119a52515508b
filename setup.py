# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Makes the wheel of cgal_l0: setuptools packs what CMake builds, and has in its component "wheel".

Environment variables:
CGAL_L0_BUILD_DIRECTORY   a complete build folder of CMake: nothing is configured or compiled. One for
                          the processor of this machine alone is refused
CMAKE_ARGS                further options for CMake: -DCGAL_L0_WITH_CUDA=ON compiles what CUDA
                          devices need, too, which takes longer. The version of the wheel then ends
                          in +cuda13, with the number of the toolkit
CMAKE_BUILD_PARALLEL_LEVEL   the number of compilers at once; by default that of the processors
CGAL_L0_WHEEL_PLATFORM    such as manylinux_2_36_x86_64: the wheel is for systems with that glibc
                          or a later one, and brings the other libraries that it loads, as TBB.
                          So it does the licenses of these and of the headers that are compiled in,
                          see scripts/library_licenses.sh
"""

import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

source = pathlib.Path(__file__).resolve().parent
project = (source / "CMakeLists.txt").read_text(encoding="utf-8")
version = re.search(r"project\(CGAL_L0_resampling VERSION ([0-9.]+) ", project)[1]


def is_on(option, given):
    """Whether the last word on an option is a true one, in a cache or on a command line of CMake."""
    values = re.findall(rf"{option}(?::\w+)?=(\w+)", given)
    return bool(values) and values[-1].upper() in ("ON", "1", "TRUE", "YES", "Y")


def options_of(build):
    return (pathlib.Path(build) / "CMakeCache.txt").read_text(encoding="utf-8")


def local_version():
    """What has code for CUDA devices has another version, such as 1.2.3+cuda13."""
    build = os.environ.get("CGAL_L0_BUILD_DIRECTORY")
    given = options_of(build) if build else os.environ.get("CMAKE_ARGS", "")
    if not is_on("CGAL_L0_WITH_CUDA", given):
        return ""
    compiler = re.search(r"CMAKE_CUDA_COMPILER(?::\w+)?=(\S+)", given)
    nvcc = compiler[1] if compiler else os.environ.get("CUDACXX", "nvcc")
    said = subprocess.run([nvcc, "--version"], check=True, capture_output=True, text=True).stdout
    return "+cuda" + re.search(r"release (\d+)", said)[1]


# A wheel may be carried to another machine, so it is compiled for every processor of the kind.
options = [
    "-DCMAKE_BUILD_TYPE=Release",
    f"-DPython_EXECUTABLE={sys.executable}",
    "-DCGAL_L0_BUILD_TESTS=OFF",
    "-DCGAL_L0_BUILD_EXAMPLES=OFF",
    "-DCGAL_L0_BUILD_BENCHMARKS=OFF",
    "-DCGAL_L0_WITH_DOCUMENTATION=OFF",
    "-DCGAL_L0_WITH_NATIVE_INSTRUCTIONS=OFF",
    "-DCGAL_L0_WITH_CUDA=OFF",
]


# What all systems have by the policies of manylinux
of_all_systems = re.compile(r"(ld-linux|linux-vdso|lib(c|m|dl|rt|pthread|gcc_s|stdc\+\+|z)\.so)")
platform = os.environ.get("CGAL_L0_WHEEL_PLATFORM")


def bring_libraries(program, folder, build):
    """Puts the libraries that the program loads where it looks for its own. Licenses of these, and
    of those that the build has compiled in, go with them.
    """
    loaded = subprocess.run(["ldd", program], check=True, capture_output=True, text=True).stdout
    if "not found" in loaded:
        sys.exit(f"Libraries of {program} are missing:\n{loaded}")
    brought = []
    folder.mkdir(parents=True, exist_ok=True)   # which a build for one processor has not
    for name, path in re.findall(r"^\s*(\S+) => (/\S+)", loaded, re.MULTILINE):
        if not of_all_systems.match(name) and not (folder / name).exists():
            shutil.copy(path, folder / name)
            brought.append(path)
    headers = (pathlib.Path(build) / "headers_of_others.txt").read_text(encoding="utf-8")
    script = source / "scripts" / "library_licenses.sh"
    subprocess.run([script, folder / "licenses", *brought, *headers.splitlines()], check=True)


def built_by_cmake(folder):
    os.environ.setdefault("CMAKE_BUILD_PARALLEL_LEVEL", str(os.cpu_count()))
    subprocess.run(
        [
            "cmake",
            "-S",
            source,
            "-B",
            folder,
            *options,
            *shlex.split(os.environ.get("CMAKE_ARGS", "")),
        ],
        check=True,
    )
    build = subprocess.run(["cmake", "--build", folder, "--target", "cgal_l0_wheel"])
    if build.returncode != 0:
        sys.exit(
            "The build failed. If there is no target cgal_l0_wheel, CMake has said above what is"
            " missing."
        )
    return folder


def complete_build(folder):
    """A folder that somebody has built, if what is in it runs on other machines too."""
    if is_on("CGAL_L0_WITH_NATIVE_INSTRUCTIONS", options_of(folder)):
        sys.exit(
            f"{folder} is compiled for the processor of this machine, and a wheel is for others too:"
            " configure it with -DCGAL_L0_WITH_NATIVE_INSTRUCTIONS=OFF."
        )
    return folder


class BuildByCMake(build_ext):
    def run(self):
        build = os.environ.get("CGAL_L0_BUILD_DIRECTORY")
        if build:
            build = complete_build(build)
        else:
            build = built_by_cmake(pathlib.Path(self.build_temp).resolve())
        files = pathlib.Path(self.build_lib).resolve()
        subprocess.run(
            ["cmake", "--install", build, "--component", "wheel", "--strip", "--prefix", files],
            check=True,
        )
        # The program and its libraries go beside the interpreter, and not into the folder of the
        # packages.
        beside = pathlib.Path(self.build_temp).resolve() / "beside"
        shutil.rmtree(beside, ignore_errors=True)
        beside.mkdir(parents=True)
        for folder in {"bin", "libexec"} & {path.name for path in files.iterdir()}:
            (files / folder).replace(beside / folder)
        if platform:
            bring_libraries(
                beside / "bin" / "l0_resample", beside / "libexec" / "cgal-l0-resampling", build
            )
        self.distribution.data_files = [
            (str(path.parent.relative_to(beside)), [str(path)])
            for path in sorted(beside.rglob("*"))
            if path.is_file()
        ]


# The extension says that the wheel is of this platform; CMake knows its sources.
setup(
    version=version + local_version(),
    packages=[],
    py_modules=[],
    ext_modules=[Extension("cgal_l0._core", [])],
    cmdclass={"build_ext": BuildByCMake},
    options={
        "build": {"build_base": "build-wheel"},
        "bdist_wheel": {"plat_name": platform} if platform else {},
    },
)
