# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Stand-ins for what the recipe uses of the module conan; they note what the recipe asks for."""

import shutil
import sys
import types
from pathlib import Path


class ConanFile:
    def __init__(self, recipe_folder, scratch):
        self.recipe_folder = str(recipe_folder)
        self.export_sources_folder = self.source_folder = str(scratch / "sources")
        self.package_folder = str(scratch / "package")
        self.required, self.generated, self.calls, self.standard = [], [], [], 0
        self.cpp_info = types.SimpleNamespace(
            properties={}, builddirs=[], libs=[], defines=[],
            set_property=lambda name, value: self.cpp_info.properties.update({name: value}))

    def requires(self, reference, **traits):
        self.required.append((reference, traits))


class CMakeToolchain:
    def __init__(self, recipe):
        self.recipe, self.cache_variables = recipe, {}

    def generate(self):
        self.recipe.generated.append("CMakeToolchain")
        self.recipe.options_of_cmake = self.cache_variables


class CMakeDeps:
    def __init__(self, recipe):
        self.recipe = recipe

    def generate(self):
        self.recipe.generated.append("CMakeDeps")


class CMake:
    def __init__(self, recipe):
        self.recipe = recipe

    def __getattr__(self, name):
        return lambda: self.recipe.calls.append(name)


def copy(recipe, pattern, src, dst):
    """Files of `src` whose path fits, where `*` also passes slashes, to the same place in `dst`."""
    files = [Path(src, pattern)]
    if pattern.endswith("/*"):
        folder = Path(src, pattern.removesuffix("/*"))
        files = [path for path in folder.rglob("*") if path.is_file()]
    if not files:
        raise FileNotFoundError(pattern)
    for path in files:
        target = Path(dst, path.relative_to(src))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(path, target)


def load(recipe, path):
    return Path(path).read_text(encoding="utf-8")


def check_min_cppstd(recipe, standard):
    recipe.standard = standard


def register():
    """Makes `import conan` give these."""
    contents = {
        "conan": {"ConanFile": ConanFile},
        "conan.tools": {},
        "conan.tools.build": {"check_min_cppstd": check_min_cppstd},
        "conan.tools.cmake": {"CMake": CMake, "CMakeDeps": CMakeDeps,
                              "CMakeToolchain": CMakeToolchain,
                              "cmake_layout": lambda recipe: None},
        "conan.tools.files": {"copy": copy, "load": load},
    }
    for name, members in contents.items():
        sys.modules[name] = types.ModuleType(name)
        vars(sys.modules[name]).update(members)
