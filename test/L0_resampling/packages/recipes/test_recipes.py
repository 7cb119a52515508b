#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""The recipes of packaging/ and CITATION.cff, as far as no package manager is needed:

  test_recipes.py SOURCE_DIRECTORY SCRATCH GENERATOR CGAL_DIR COMPILED_LIBRARY

All begins with the archive of the sources that a release has. The port of vcpkg is carried out
with CMake, but for the compiler, as COMPILED_LIBRARY is built already, and a program built with
what it installs. The recipe of Conan is read, its sources are exported, and CMake configures these
with the options it sets. That of conda is read, and its script is run with a CMake that configures
and does not build.
"""

import importlib.util
import json
import os
import platform
import re
import shutil
import subprocess
import sys
from pathlib import Path

import conan_stand_in

try:
    import jinja2
    import yaml
except ImportError as error:
    print(f"{error} (Debian: python3-yaml, python3-jinja2)")
    sys.exit(77)



def run(*command):
    done = subprocess.run([str(word) for word in command], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True)
    assert done.returncode == 0, f"{command}:\n{done.stdout}"
    return done.stdout


def unpacked_release(tree):
    """What scripts/tag_release.sh packs, with changes that are not committed; the tree itself where
    it is no repository, but unpacked already."""
    if not (tree / ".git").exists():
        return tree
    git = ["git", "-C", tree, "-c", "user.name=test", "-c", "user.email=test@example.org"]
    commit = run(*git, "stash", "create").strip() or "HEAD"
    run(*git, "archive", "--prefix=release/", "-o", scratch / "release.tar", commit)
    run("tar", "-x", "-C", scratch, "-f", scratch / "release.tar")
    return scratch / "release"


scratch = Path(sys.argv[2])
generator, cgal, library = sys.argv[3:]
shutil.rmtree(scratch, ignore_errors=True)
scratch.mkdir(parents=True)
source = unpacked_release(Path(sys.argv[1]))
version = run(source / "scripts/project_version.sh").strip()


def check_citation():
    """The fields of the Citation File Format 1.2.0 that this file has."""
    citation = yaml.safe_load((source / "CITATION.cff").read_text(encoding="utf-8"))
    assert citation["cff-version"] == "1.2.0" and citation["type"] == "software"
    assert citation["version"] == version and citation["license"] == "GPL-3.0-or-later"
    assert citation["message"] and citation["title"]
    required = {"cff-version", "message", "title", "type", "version", "license", "authors"}
    optional = {"abstract", "date-released", "keywords", "references", "repository-code"}
    assert set(citation) - optional == required
    for author in citation["authors"]:
        assert author.get("name") or author.get("family-names"), author
    for reference in citation["references"]:
        assert {"type", "title", "authors"} <= set(reference), reference


def check_manifest(port):
    """By the rules of vcpkg's vcpkg.schema.json for the fields that this one has."""
    manifest = json.loads((port / "vcpkg.json").read_text(encoding="utf-8"))
    fields = {"name", "version", "description", "license", "supports", "dependencies"}
    assert set(manifest) == fields
    assert manifest["name"] == port.name and re.fullmatch(r"[a-z0-9]+(-[a-z0-9]+)*", port.name)
    assert manifest["version"] == version and re.fullmatch(r"\d+(\.\d+)*", version)
    assert manifest["license"] == "GPL-3.0-or-later" and manifest["supports"] == "linux"
    names = set()
    for dependency in manifest["dependencies"]:
        named = {"name": dependency} if isinstance(dependency, str) else dependency
        names.add(named["name"])
        assert named.get("host", False) == named["name"].startswith("vcpkg-"), dependency
    assert names == {"cgal", "eigen3", "tbb", "vcpkg-cmake", "vcpkg-cmake-config"}


def check_port(port):
    run("cmake", f"-DPORT_DIRECTORY={port}", f"-DSCRATCH={scratch}/vcpkg",
        f"-DGENERATOR={generator}", f"-DCGAL_DIR={cgal}", f"-DLIBRARY={library}",
        "-P", Path(__file__).with_name("vcpkg_stand_in.cmake"))
    build = scratch / "vcpkg" / "consumer"
    # moved, as vcpkg moves it: no path of the build may be left in it
    prefix = (scratch / "vcpkg" / "installed").rename(scratch / "vcpkg" / "moved")
    run("cmake", "-S", source / "test/L0_resampling/packages/consumer", "-B", build,
        "-G", generator,
        f"-DCMAKE_PREFIX_PATH={prefix}", f"-DCGAL_DIR={cgal}", "-DCMAKE_BUILD_TYPE=Release",
        "-DCMAKE_CXX_FLAGS_RELEASE=-O0 -DNDEBUG")
    run("cmake", "--build", build, "--target", "consumer_of_compiled")
    run(build / "consumer_of_compiled")


def options_of_the_port(port):
    text = (port / "portfile.cmake").read_text(encoding="utf-8")
    return dict(re.findall(r"^ *-D(\w+)=(\w+)$", text, re.MULTILINE))


def check_conan(folder, options):
    spec = importlib.util.spec_from_file_location("recipe", folder / "conanfile.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    recipe = module.CgalL0ResamplingRecipe(folder, scratch / "conan")
    recipe.set_version()
    assert recipe.name == "cgal-l0-resampling" and recipe.version == version
    assert recipe.license == "GPL-3.0-or-later"
    for step in ("export_sources", "requirements", "validate", "layout", "generate", "build",
                 "package", "package_info"):
        getattr(recipe, step)()

    assert recipe.standard == 17 and set(recipe.generated) == {"CMakeDeps", "CMakeToolchain"}
    names = [reference.split("/")[0] for reference, _ in recipe.required]
    assert names == ["cgal", "eigen", "onetbb"]
    assert all(traits["transitive_headers"] for _, traits in recipe.required)
    assert recipe.calls == ["configure", "build", "install"]
    assert recipe.options_of_cmake == options, "Conan and vcpkg build with other options"
    assert Path(recipe.package_folder, "licenses", "LICENSE").exists()

    # The sources suffice, and the package is where the recipe says.
    build = scratch / "conan" / "build"
    run("cmake", "-S", recipe.source_folder, "-B", build, "-G", generator, f"-DCGAL_DIR={cgal}",
        "-DCMAKE_INSTALL_LIBDIR=lib", *(f"-D{name}={value}" for name, value in options.items()))
    scripts = "".join(path.read_text(encoding="utf-8")
                      for path in build.rglob("cmake_install.cmake"))
    assert recipe.cpp_info.properties["cmake_find_mode"] == "none"
    for builddir in recipe.cpp_info.builddirs:
        assert f'"${{CMAKE_INSTALL_PREFIX}}/{builddir}"' in scripts, builddir
    for library in recipe.cpp_info.libs:
        assert f"lib{library}.a" in scripts, library
    assert (Path(recipe.source_folder) / "include/CGAL/l0_resample_point_set.h").exists()


def check_conda(folder, options):
    """By the fields of conda-build's meta.yaml, of which a comment `# [...]` selects a platform."""
    text = (folder / "meta.yaml").read_text(encoding="utf-8")
    recipe = yaml.safe_load(jinja2.Environment(undefined=jinja2.StrictUndefined).from_string(
        text).render(compiler=lambda language: f"{language}_compiler"))
    assert set(recipe) == {"package", "source", "build", "requirements", "test", "about"}
    assert recipe["package"] == {"name": "cgal-l0-resampling", "version": version}
    assert (folder / recipe["source"]["path"]).resolve() == source.resolve()
    assert recipe["about"]["license"] == "GPL-3.0-or-later"
    assert (source / recipe["about"]["license_file"]).exists()
    required = recipe["requirements"]
    assert set(required) == {"build", "host", "run"}
    # Headers need at run time what they need when they are compiled, in the same versions.
    needed_by_headers = {line for line in required["host"]
                         if line.split()[0] in {"cgal-cpp", "eigen", "tbb-devel"}}
    assert len(needed_by_headers) == 3 and needed_by_headers <= set(required["run"])

    # A CMake that builds and installs nothing
    place = scratch / "conda"
    (place / "bin").mkdir(parents=True)
    stand_in = place / "bin/cmake"
    stand_in.write_text(f"""#!/bin/sh
case $1 in --build | --install) exit 0 ;; esac
exec {shutil.which("cmake")} "$@"
""", encoding="utf-8")
    stand_in.chmod(0o755)
    copied = place / "sources"
    shutil.copytree(source, copied, ignore=shutil.ignore_patterns(
        "build*", ".git", "output", "test", "benchmark", "fig"))
    environment = {**os.environ, "PATH": f"{place}/bin:{os.environ['PATH']}",
                   "PREFIX": f"{place}/prefix", "PYTHON": "/usr/bin/python3",
                   "CMAKE_ARGS": f"-DCGAL_DIR={cgal} -DCMAKE_VERBOSE_MAKEFILE=ON"}
    done = subprocess.run(["bash", folder / "build.sh"], cwd=copied, env=environment, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    assert done.returncode == 0, done.stdout
    cache = (copied / "build/CMakeCache.txt").read_text(encoding="utf-8")
    for name, value in {**options, "CGAL_L0_BUILD_TOOL": "ON", "CGAL_L0_WITH_PYTHON": "ON",
                        "CMAKE_VERBOSE_MAKEFILE": "ON"}.items():
        assert re.search(rf"^{name}:\w+={value}$", cache, re.MULTILINE), name
    scripts = "".join(path.read_text(encoding="utf-8")
                      for path in (copied / "build").rglob("cmake_install.cmake"))
    wanted_files = ["lib/cmake/CGAL_L0_resampling", "libCGAL_L0_resampling_compiled.a", "/cgal_l0"]
    if platform.machine() == "x86_64":
        wanted_files.append("libexec/cgal-l0-resampling/glibc-hwcaps/x86-64-v4")
    for wanted in wanted_files:
        assert wanted in scripts, wanted


def main():
    conan_stand_in.register()
    check_citation()
    port = source / "packaging/vcpkg/cgal-l0-resampling"
    check_manifest(port)
    check_conan(source / "packaging/conan", options_of_the_port(port))
    check_conda(source / "packaging/conda", options_of_the_port(port))
    check_port(port)


if __name__ == "__main__":
    main()
