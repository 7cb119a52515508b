# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Makes a wheel of a build that is there, installs it into an empty environment and uses it; makes
a source distribution:

test_wheel.py SOURCE BUILD SCRATCH

Exit status 77 if pip, setuptools or wheel is not installed.
"""

import importlib.util
import os
import pathlib
import platform
import re
import shutil
import subprocess
import sys
import tarfile
import venv
import zipfile

SKIPPED = 77

# One wheel for all Linux systems with the glibc of this one or a later one
LIBC, VERSION = platform.libc_ver()
PLATFORM = f"manylinux_{VERSION.replace('.', '_')}_{platform.machine()}" if LIBC == "glibc" else ""

USE = """
import importlib.metadata, cgal_l0, numpy
print(cgal_l0.__file__)
assert importlib.metadata.version("cgal-l0").partition("+")[0] == cgal_l0.__version__
points = numpy.random.default_rng(1).random((2000, 3)) * [1, 1, 0.01]
positions, normals = cgal_l0.l0_resample_point_set(points, number_of_output_points=500)
cgal_l0.write_points("clean.ply", positions, normals)
assert len(cgal_l0.read_points("clean.ply").points) == 500
"""


def run(*command, **options):
    outcome = subprocess.run(
        [str(word) for word in command], capture_output=True, text=True, **options
    )
    if outcome.returncode != 0:
        sys.exit(
            f"{command} ended with status {outcome.returncode}:\n{outcome.stdout}\n{outcome.stderr}"
        )
    return outcome.stdout


def copy_of(source, scratch):
    """What a wheel is built of, where it may be written to."""
    copy = scratch / "source"
    copy.mkdir(parents=True)
    for name in (
        "CMakeLists.txt",
        "LICENSE",
        "MANIFEST.in",
        "README.md",
        "pyproject.toml",
        "setup.py",
    ):
        shutil.copy(source / name, copy)
    for name in ("cmake", "include", "src"):
        shutil.copytree(source / name, copy / name, ignore=shutil.ignore_patterns("__pycache__"))
    (copy / "scripts").mkdir()
    shutil.copy(source / "scripts" / "library_licenses.sh", copy / "scripts")
    return copy


def installed(wheel, scratch):
    """The folder of an environment that has the wheel, and the packages of this system."""
    folder = scratch / "environment"
    venv.create(folder, system_site_packages=True, with_pip=False)
    run(
        sys.executable,
        "-m",
        "pip",
        "--python",
        folder / "bin" / "python",
        "install",
        "--no-index",
        "--no-deps",
        wheel,
    )
    return folder


def check_licenses_of_headers(build, wheel):
    """Each library whose headers are compiled in has its text, and pip leaves none out."""
    headers = (build / "headers_of_others.txt").read_text(encoding="utf-8").split()
    assert len(headers) == 5, headers
    with zipfile.ZipFile(wheel) as content:
        texts = [content.read(name).decode() for name in content.namelist() if "/licenses/" in name]
    for holder in ("CGAL", "Mozilla Public License", "Henry Schreiner", "Lohmann", "Wenzel Jakob"):
        assert any(holder in text for text in texts), holder


def check_libraries(loaded, environment):
    """Those that not all systems have come with the wheel, and need no later glibc than it says."""
    if not PLATFORM:
        return
    libraries = dict(re.findall(r"^\s*(\S+) => (/\S+)", loaded, re.MULTILINE))
    foreign = {
        path
        for name, path in libraries.items()
        if not path.startswith(f"{environment}/")
        and not re.match(r"lib(c|m|dl|rt|pthread|gcc_s|stdc\+\+|z)\.so", name)
    }
    assert not foreign, foreign
    needed = (0, 0)
    for file in environment.rglob("*"):
        if file.is_file() and (file.name == "l0_resample" or ".so" in file.suffixes):
            names = run("objdump", "-T", file)
            versions = re.findall(r"\bGLIBC_(\d+)\.(\d+)", names)
            needed = max(needed, *((int(a), int(b)) for a, b in versions))
    assert needed <= tuple(map(int, PLATFORM.split("_")[1:3])), needed


def refusal_of_build(copy, environment):
    """What a build that fails prints of errors."""
    build = subprocess.run(
        [sys.executable, "setup.py", "build_ext"],
        cwd=copy,
        capture_output=True,
        text=True,
        check=False,
        env={**os.environ, **environment},
    )
    assert build.returncode != 0
    return build.stderr


def check_options(copy, scratch):
    """Nobody waits for CUDA who has not asked for it, and who asks has the last word."""
    stand_in = scratch / "stand_in" / "cmake"
    stand_in.parent.mkdir()
    stand_in.write_text(f'#!/bin/sh\necho "$@" > {scratch}/options\nexit 1\n')
    stand_in.chmod(0o755)
    nvcc = stand_in.with_name("nvcc")
    nvcc.write_text("#!/bin/sh\necho 'Cuda compilation tools, release 77.1, V77.1.2'\n")
    nvcc.chmod(0o755)
    asked = "-DCGAL_L0_WITH_CUDA=ON"
    environment = {
        **os.environ,
        "PATH": f"{stand_in.parent}:{os.environ['PATH']}",
        "CUDACXX": str(nvcc),
        "CMAKE_ARGS": asked,
    }
    refusal_of_build(copy, environment)
    options = (scratch / "options").read_text(encoding="utf-8").split()
    assert options[-1] == asked and "-DCGAL_L0_WITH_CUDA=OFF" in options, options
    # What has code for devices has another version.
    version = run(sys.executable, "setup.py", "--version", cwd=copy).strip()
    with_cuda = run(sys.executable, "setup.py", "--version", cwd=copy, env=environment).strip()
    assert with_cuda == f"{version}+cuda77", (version, with_cuda)


def check_refusal(copy, scratch):
    """What runs on the processor of this machine alone is no wheel."""
    build = scratch / "native"
    build.mkdir()
    (build / "CMakeCache.txt").write_text("CGAL_L0_WITH_NATIVE_INSTRUCTIONS:BOOL=ON\n")
    refusal = refusal_of_build(copy, {"CGAL_L0_BUILD_DIRECTORY": str(build)})
    assert f"{build} is compiled for the processor of this machine" in refusal, refusal


def check_one_processor(copy, program, build, scratch):
    """A build for one kind of processor has no folder of libraries; those of others go there too.

    program: loads only these
    """
    one = scratch / "one_processor"
    one.mkdir()
    (one / "CMakeCache.txt").touch()
    shutil.copy(build / "headers_of_others.txt", one)
    stand_in = one / "cmake"   # whose last argument is the prefix
    stand_in.write_text(
        f'#!/bin/sh\nfor prefix; do :; done\nmkdir -p "$prefix/bin"\n'
        f'cp "{program}" "$prefix/bin/l0_resample"\n'
    )
    stand_in.chmod(0o755)
    run(
        sys.executable,
        "setup.py",
        "build_ext",
        "--build-temp",
        one / "temp",
        "--build-lib",
        one / "lib",
        cwd=copy,
        env={
            **os.environ,
            "PATH": f"{one}:{os.environ['PATH']}",
            "CGAL_L0_BUILD_DIRECTORY": str(one),
            "CGAL_L0_WHEEL_PLATFORM": PLATFORM,
        },
    )
    names = {path.name for path in (one / "temp").rglob("libexec/cgal-l0-resampling/*")}
    assert "licenses" in names and any(name.startswith("libtbb.so") for name in names), names


def check_source_distribution(copy, scratch):
    """It has all that CMake wants to see, and no more than what is needed."""
    run(
        sys.executable,
        "-c",
        "from setuptools import build_meta; build_meta.build_sdist('../distribution')",
        cwd=copy,
    )
    (archive,) = (scratch / "distribution").glob("cgal*.tar.gz")
    with tarfile.open(archive) as tar:
        tar.extractall(scratch / "unpacked")
    (folder,) = (scratch / "unpacked").iterdir()
    wanted = {
        path.relative_to(copy)
        for name in ("cmake", "include", "scripts", "src")
        for path in (copy / name).rglob("*.*")
    }
    missing = {path for path in wanted if not (folder / path).exists()}
    assert not missing, missing
    assert (folder / "setup.py").exists() and (folder / "pyproject.toml").exists()
    unwanted = [
        path for path in folder.iterdir() if path.name in ("test", "data", "benchmark", "doc")
    ]
    assert not unwanted, unwanted


def main():
    if missing := [
        name for name in ("pip", "setuptools", "wheel") if not importlib.util.find_spec(name)
    ]:
        print(", ".join(missing), "not installed, so no wheel was made")
        return SKIPPED
    source, build, scratch = map(pathlib.Path, sys.argv[1:])
    shutil.rmtree(scratch, ignore_errors=True)
    copy = copy_of(source, scratch)
    os.environ.pop("PYTHONPATH", None)   # the package is that of the wheel only
    run(
        sys.executable,
        "-m",
        "pip",
        "wheel",
        copy,
        "--no-build-isolation",
        "--no-deps",
        "--no-index",
        "--no-cache-dir",
        "-w",
        scratch,
        env={
            **os.environ,
            "CGAL_L0_BUILD_DIRECTORY": str(build),
            "CGAL_L0_WHEEL_PLATFORM": PLATFORM,
        },
    )
    (wheel,) = scratch.glob("cgal_l0-*.whl")
    assert not PLATFORM or wheel.stem.endswith(PLATFORM), wheel
    assert wheel.stat().st_size < 100e6, wheel.stat()
    with zipfile.ZipFile(wheel) as content:
        names = set(content.namelist())
    stubs = {f"cgal_l0/{path.name}" for path in (source / "src" / "cgal_l0").glob("*.py*")} | {
        "cgal_l0/py.typed"
    }
    assert stubs <= names, stubs - names
    # The program and the module find libraries where they lie in a build, too.
    folder = pathlib.PurePath("libexec", "cgal-l0-resampling")
    libraries = {
        str(folder / path.relative_to(build / folder))
        for path in (build / folder).rglob("*.so.*")
    }
    data = {name.partition(".data/data/")[2] for name in names}
    assert libraries <= data, libraries - data
    if PLATFORM:
        licenses = {pathlib.PurePath(name).name for name in data if f"{folder}/licenses/" in name}
        assert {"libtbb12", "Apache-2.0"} <= licenses, licenses
        assert any(name.startswith("libpng") for name in licenses), licenses
        check_licenses_of_headers(build, wheel)

    environment = installed(wheel, scratch)
    place = run(environment / "bin" / "python", "-B", "-c", USE, cwd=scratch)
    assert place.startswith(str(environment)), place
    assert run(environment / "bin" / "l0_resample", "--version").startswith("l0_resample ")
    run(environment / "bin" / "l0_resample", "clean.ply", "half.npy", cwd=scratch)
    loaded = run("ldd", environment / "bin" / "l0_resample")
    (module,) = environment.rglob("_core*.so")
    for libraries_of_file in (loaded, run("ldd", module)):
        check_libraries(libraries_of_file, environment)
    assert not libraries or f"{environment}/bin/../{folder}/" in loaded, loaded
    check_options(copy, scratch)
    check_refusal(copy, scratch)
    if PLATFORM and libraries:   # else all of this was about such a build
        check_one_processor(copy, build / folder / "libCGAL_L0_resampling.so", build, scratch)
    check_source_distribution(copy, scratch)
    return 0


if __name__ == "__main__":
    sys.exit(main())
