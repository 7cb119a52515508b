# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Where benchmarks put what they measure, and how documents read it.

The option `--output FOLDER/NAME` of a benchmark stands for three files:

  FOLDER/output/NAME.json    all that was measured; not part of the repository
  FOLDER/results/NAME.md     the tables made of it, which are
  FOLDER/results/NAME.json   the few figures that documents compute with, where there are any

README and manual quote the files of `results` only, with the commit that they were measured at
(`measured.py`). A benchmark that keeps part of an earlier run needs the file of `output`.
"""

import json
import os
import platform
import re
import shlex
import sys
from dataclasses import dataclass

from measured import note_run


def processor():
    """What a benchmark runs on."""
    with open("/proc/cpuinfo", encoding="ascii", errors="replace") as stream:
        return next((line.split(":", 1)[1].strip() for line in stream if line.startswith("model name")), platform.machine())


def command_line(program, arguments):
    """As it stands in the results: without the folders of this machine."""
    words = [os.path.basename(word) if os.path.isabs(word) else word for word in arguments]
    return shlex.join([program, *words])


def raw_file(output):
    return output.parent / "output" / f"{output.name}.json"


def tables_file(output):
    return output.parent / "results" / f"{output.name}.md"


def figures_file(output):
    return output.parent / "results" / f"{output.name}.json"


def load_json(path):
    return json.loads(path.read_text(encoding="utf-8"))


def load_raw(output):
    """All that an earlier run with this --output has measured."""
    path = raw_file(output)
    if not path.exists():
        raise ValueError(f"{path}, which an earlier run with this --output writes, is not there")
    return load_json(path)


def write_json(path, result):
    """With the innermost objects and lists on a line each."""
    text = json.dumps(result, indent=1, allow_nan=False)
    text = re.sub(r"\{[^{}]*\}|\[[^][{}]*\]", lambda found: " ".join(found.group().split()), text)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(text + "\n", encoding="utf-8")


def rounded(value):
    """The same with floating-point numbers of six digits, as many as any document shows."""
    if isinstance(value, dict):
        return {key: rounded(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [rounded(item) for item in value]
    return float(f"{value:.6g}") if isinstance(value, float) else value


def write_result(output, result, markdown, figures=None):
    """Writes the files of `--output`; prints the tables where that is None."""
    if output is None:
        print(markdown, end="")
        return
    write_json(raw_file(output), result)
    tables_file(output).parent.mkdir(parents=True, exist_ok=True)
    tables_file(output).write_text(markdown, encoding="utf-8")
    if figures is not None:
        write_json(figures_file(output), rounded(figures))
    unnoted = note_run(output)
    if unnoted:
        print(f"{tables_file(output).name}: {unnoted}", file=sys.stderr)


@dataclass(frozen=True)
class Read_table:
    heading: str    # the last one before the table
    header: list
    rows: list      # of cells, as they are printed


def cells(line):
    return [text.strip() for text in line.strip()[1:-1].split("|")]


def read_tables(markdown):
    tables, lines, heading = [], [], ""
    for line in [*markdown.splitlines(), ""]:
        if line.startswith("|"):
            lines.append(line)
            continue
        if lines:
            tables.append(Read_table(heading, cells(lines[0]), [cells(text) for text in lines[2:]]))
            lines = []
        if line.startswith("#"):
            heading = line.lstrip("# ")
    return tables


def found_in(pattern, markdown):
    """The groups of the first match, which has to be there."""
    match = re.search(pattern, markdown)
    if match is None:
        raise ValueError(f"no table says {pattern}")
    return match.groups()
