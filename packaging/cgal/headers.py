#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""The headers of the package as CGAL asks for them: headers.py (check | complete | for_cgal) FOLDER

- check: says what CGAL's own checks would refuse, and ends with status 1 if there is anything.
- complete: gives each header the lines that CGAL begins a file with.
- for_cgal: makes the headers of a CGAL tree of them, which say that they are part of CGAL. There,
  those in `internal` include the header of the package's license too, as public ones do everywhere.

FOLDER is an `include` or a part of one.
"""

import re
import sys
from pathlib import Path

HOLDER = "The CGAL::L0_resampling authors"
COPYRIGHT = f"// Copyright (c) 2026  {HOLDER}.\n// All rights reserved.\n//\n"
PART_OF_CGAL = "// This file is part of CGAL (www.cgal.org).\n//\n"
LICENSE = "// SPDX-License-Identifier: GPL-3.0-or-later\n"
HEAD = (COPYRIGHT + "// $URL$\n// $Id$\n" + LICENSE
        + f"//\n// Author(s)     : {HOLDER}\n")
INCLUDE_OF_LICENSE = "#include <CGAL/license/L0_resampling.h>\n"
GUARD = re.compile(r"^#ifndef (CGAL_\w+_H)\n#define (\w+)\n", re.MULTILINE)

# Not read alone, but inside of what is made of each of their lines
WITHOUT_GUARD = ("named_parameters_interface.h", "value_parameters.h")
PUBLIC = re.compile(r"/CGAL/(L0_resampling/)?\w+\.h$")
# As CGAL's headers have it: after the include guard, and alone
PLACE_OF_LICENSE = re.compile(GUARD.pattern + rf"\n{re.escape(INCLUDE_OF_LICENSE)}\n", re.MULTILINE)

FORBIDDEN = [
    (re.compile(r"(?<!\\)\b(?:min|max)(?:<[^>]*>)?\s*\("),
     "min and max are macros on Windows: (std::min)(...), (x.min)(), at_most(...)"),
    (re.compile(r"(?<!\w)(?:assert|abort|exit)\("), "a library neither asserts nor ends a program"),
    (re.compile(r"\t|[ \t]$", re.MULTILINE), "a tab, or a blank at the end of a line"),
]


def headers(folder):
    found = sorted(Path(folder).rglob("*.h"))
    if not found:
        sys.exit(f"headers.py: there are no headers in {folder}")
    return found


def is_public(path):
    return PUBLIC.search(path.resolve().as_posix()) and path.name not in WITHOUT_GUARD


def complaints_of(path, text, guards):
    if not text.startswith(HEAD):
        yield "does not begin as CGAL's files do: headers.py complete adds that"
    if path.name not in WITHOUT_GUARD:
        guard = GUARD.search(text)
        if guard is None or guard[1] != guard[2]:
            yield "has no include guard CGAL_..._H"
        else:
            other = guards.setdefault(guard[1], path)
            if other != path:
                yield f"has the include guard of {other}"
    if is_public(path) and not PLACE_OF_LICENSE.search(text):
        yield f"is public and lacks {INCLUDE_OF_LICENSE.strip()} behind its include guard"
    for block in re.findall(r"(?:^#include .*\n)+", text, re.MULTILINE):
        lines = block.splitlines()
        if lines != sorted(lines):
            yield f"has includes out of order, from {lines[0]}"
    for pattern, sentence in FORBIDDEN:
        match = pattern.search(text)
        if match:
            line = text.count("\n", 0, match.start()) + 1
            yield f"line {line}: {sentence}"


def check(folder):
    guards = {}
    count = 0
    for path in headers(folder):
        for complaint in complaints_of(path, path.read_text(encoding="utf-8"), guards):
            print(f"{path} {complaint}", file=sys.stderr)
            count += 1
    return count


def complete(folder):
    short = COPYRIGHT + LICENSE
    for path in headers(folder):
        text = path.read_text(encoding="utf-8")
        if text.startswith(short):
            path.write_text(HEAD + text[len(short):], encoding="utf-8")
        elif not text.startswith(HEAD):
            print(f"{path} begins in another way", file=sys.stderr)
    return 0


def for_cgal(folder):
    for path in headers(folder):
        text = path.read_text(encoding="utf-8")
        text = text.replace(COPYRIGHT, COPYRIGHT + PART_OF_CGAL, 1)
        if "internal" in path.parts and INCLUDE_OF_LICENSE not in text:
            text = GUARD.sub(lambda guard: guard[0] + "\n" + INCLUDE_OF_LICENSE, text, count=1)
        path.write_text(text, encoding="utf-8")
    return 0


TASKS = {"check": check, "complete": complete, "for_cgal": for_cgal}

if __name__ == "__main__":
    if len(sys.argv) != 3 or sys.argv[1] not in TASKS:
        sys.exit(__doc__)
    sys.exit(1 if TASKS[sys.argv[1]](sys.argv[2]) else 0)
