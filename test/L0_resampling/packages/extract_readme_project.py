#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the C++ program and the CMakeLists.txt that a page shows to a folder, to be compiled
there:

  extract_readme_project.py README.md FOLDER

The page has one block of each language; the file name of the program is the one that the
CMakeLists.txt asks for.
"""

import re
import sys
from pathlib import Path


def only_block(page, language):
    blocks = re.findall(rf"^```{re.escape(language)}\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)
    if len(blocks) != 1:
        sys.exit(f"{len(blocks)} blocks of {language}, of which one is compiled")
    return blocks[0]


def main():
    page = Path(sys.argv[1]).read_text(encoding="utf-8")
    folder = Path(sys.argv[2])
    program, project = only_block(page, "cpp"), only_block(page, "cmake")
    name = re.search(r"add_executable\(\w+ (\w+\.cpp)\)", project)[1]
    folder.mkdir(parents=True)
    (folder / name).write_text(program, encoding="utf-8")
    (folder / "CMakeLists.txt").write_text(project, encoding="utf-8")


if __name__ == "__main__":
    main()
