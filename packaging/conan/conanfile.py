# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

import re
from pathlib import Path

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy, load


class CgalL0ResamplingRecipe(ConanFile):
    name = "cgal-l0-resampling"
    license = "GPL-3.0-or-later"
    description = "L0 resampling of point sets in the style of CGAL"
    topics = ("cgal", "geometry", "point-cloud", "resampling")
    package_type = "static-library"
    settings = "os", "compiler", "build_type", "arch"
    # The library holds position-independent code, whatever links with it.

    @property
    def _source_tree(self):
        return Path(self.recipe_folder).resolve().parents[1]

    def set_version(self):
        project = load(self, str(self._source_tree / "CMakeLists.txt"))
        self.version = re.search(r"project\(CGAL_L0_resampling VERSION ([0-9.]+) ", project)[1]

    def export_sources(self):
        for pattern in (
            "CMakeLists.txt",
            "LICENSE",
            "README.md",
            "cmake/*",
            "include/*",
            "src/CGAL_L0_resampling_compiled/*",
        ):
            copy(self, pattern, src=str(self._source_tree), dst=self.export_sources_folder)

    def requirements(self):
        self.requires("cgal/[>=5.5 <7]", transitive_headers=True)
        self.requires("eigen/[>=3.3.7 <6]", transitive_headers=True)
        self.requires("onetbb/[>=2021 <2023]", transitive_headers=True, transitive_libs=True)

    def validate(self):
        check_min_cppstd(self, 17)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        CMakeDeps(self).generate()
        toolchain = CMakeToolchain(self)
        for part in (
            "BUILD_BENCHMARKS",
            "BUILD_EXAMPLES",
            "BUILD_TESTS",
            "BUILD_TOOL",
            "WITH_CUDA",
            "WITH_DOCUMENTATION",
            "WITH_NATIVE_INSTRUCTIONS",
            "WITH_PYTHON",
        ):
            toolchain.cache_variables[f"CGAL_L0_{part}"] = "OFF"
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()
        copy(
            self, "LICENSE", src=self.source_folder, dst=str(Path(self.package_folder, "licenses"))
        )

    def package_info(self):
        # find_package() finds what CMake has installed, with all targets.
        self.cpp_info.set_property("cmake_find_mode", "none")
        self.cpp_info.builddirs.append("lib/cmake/CGAL_L0_resampling")
        self.cpp_info.libs = ["CGAL_L0_resampling_compiled"]
        self.cpp_info.defines = ["CGAL_L0_LINKED_WITH_COMPILED"]
