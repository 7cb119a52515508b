#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Programs that are compiled as one run as if each was alone: test_programs_in_one.py COMPILER"""

import subprocess
import sys
import tempfile
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[3] / "scripts" / "programs_in_one.py"
HEADER = """#ifndef VALUE_H
#define VALUE_H
inline int value() { return 3; }
#endif
"""
# Both have a `main()` and a `status()`, and one header beside them.
PLAIN = """#include "value.h"
int status() { return value() + 1; }
int main() { return status(); }
"""
WITH_ARGUMENTS = """#include "value.h"
#include <cstring>
int status() { return value() + 2; }
int main(int argc, char* argv[])
{
  return argc == 2 && std::strcmp(argv[1], "argument") == 0 ? status() : 100;
}
"""
USER_OF_LIBRARY = """int main_of_plain(int, char*[]);
int main_of_with_arguments(int, char*[]);
int main(int argc, char* argv[])
{
  return 10 * main_of_plain(argc, argv) + main_of_with_arguments(argc, argv);
}
"""


def run(*command):
    return subprocess.run([str(word) for word in command], stderr=subprocess.DEVNULL).returncode


def main(compiler):
    options = ["-std=c++17", "-Wall", "-Wextra", "-Wpedantic", "-Werror"]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        sources = [folder / "plain.cpp", folder / "with_arguments.cpp"]
        for path, text in zip([*sources, folder / "value.h", folder / "user.cpp"],
                              [PLAIN, WITH_ARGUMENTS, HEADER, USER_OF_LIBRARY]):
            path.write_text(text, encoding="utf-8")
        made = folder / "elsewhere" / "made.cpp"
        made.parent.mkdir()

        program = folder / "program"
        assert run(SCRIPT, made, *sources) == 0
        assert run(compiler, *options, made, "-o", program) == 0
        assert run(program, "plain") == 4
        assert run(program, "with_arguments", "argument") == 5
        assert run(program, "with_arguments") == 100
        assert run(program, "another") == 1 and run(program) == 1

        assert run(SCRIPT, "--library", made, *sources) == 0
        assert run(compiler, *options, made, folder / "user.cpp", "-o", program) == 0
        assert run(program, "argument") == 45


if __name__ == "__main__":
    main(sys.argv[1])
