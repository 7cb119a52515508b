#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a source file that has several programs in one, so that what they share is compiled once:

  programs_in_one.py OUTPUT SOURCE...
  programs_in_one.py --library OUTPUT SOURCE...

Each source lies in a namespace with the name of its file, and runs where the program is called with
that name; of a library, where `main_of_<name>()` is called. All headers stand before, outside of the
namespaces; where the sources include them again, their guards leave
nothing of them.
"""

import re
import sys
from pathlib import Path

# Of a list that the macro before it makes something of
INCLUDE_OF_LIST = re.compile(r"^(#define (?:.*\\\n)*.*\n)#include .*$", re.MULTILINE)
DIRECTIVE = re.compile(r"^ *# *(include|if|ifdef|ifndef|else|elif|endif)\b(.*)$", re.MULTILINE)
CALL = """
/// Calls a `main()` with the arguments that it takes.
template <typename... Arguments>
int call(int (*program)(Arguments...), [[maybe_unused]] int argc, [[maybe_unused]] char* argv[])
{
  if constexpr (sizeof...(Arguments) == 0)
    return program();
  else
    return program(argc, argv);
}
"""
MAIN = """
int main(int argc, char* argv[])
{
  const std::string name = argc > 1 ? argv[1] : "";"""
END_OF_MAIN = """\
  std::cerr << "This program has no \\"" << name << "\\"." << std::endl;
  return 1;
}"""


def directives(source):
    """What `source` includes and under which conditions, to be read from another folder."""
    text = INCLUDE_OF_LIST.sub(r"\1", source.read_text(encoding="utf-8"))
    for word, rest in DIRECTIVE.findall(text):
        name = re.fullmatch(r' *"([^"]*)".*', rest)
        beside = source.parent / name[1] if name else None
        if beside and beside.exists():
            rest = f' "{beside.resolve()}"'
        yield f"#{word}{rest}"


def lines_of(sources, is_library):
    yield "// Made by programs_in_one.py."
    for source in sources:
        yield from directives(source)
    yield from ("#include <iostream>", "#include <string>")
    for source in sources:
        yield from (f"namespace {source.stem} {{", f'#include "{source.resolve()}"', "}")
    yield CALL
    if is_library:
        for source in sources:
            yield f"int main_of_{source.stem}(int argc, char* argv[])"
            yield f"{{ return call({source.stem}::main, argc, argv); }}"
        return
    yield MAIN
    for source in sources:
        yield f'  if (name == "{source.stem}")'
        yield f"    return call({source.stem}::main, argc - 1, argv + 1);"
    yield END_OF_MAIN


def main(output, *sources, is_library=False):
    lines = lines_of([Path(name) for name in sources], is_library)
    Path(output).write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    if sys.argv[1] == "--library":
        main(*sys.argv[2:], is_library=True)
    else:
        main(*sys.argv[1:])
