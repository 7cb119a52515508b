# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

from pathlib import Path

from conan import ConanFile
from conan.tools.build import can_run
from conan.tools.cmake import CMake, cmake_layout


class Consumer(ConanFile):
    """Builds and runs the project that the tests of an install have."""

    settings = "os", "compiler", "build_type", "arch"
    generators = "CMakeDeps", "CMakeToolchain"

    def requirements(self):
        self.requires(self.tested_reference_str)

    def layout(self):
        cmake_layout(self)

    def build(self):
        cmake = CMake(self)
        project = Path(self.recipe_folder).resolve().parents[2] / "test/L0_resampling/packages/consumer"
        cmake.configure(build_script_folder=str(project))
        cmake.build()

    def test(self):
        if can_run(self):
            for program in ("consumer", "consumer_of_compiled"):
                self.run(str(Path(self.build_folder, program)), env="conanrun")
