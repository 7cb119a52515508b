# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Search/replace edits of source files, which planted bugs are made of.

A table is a TOML file with rows such as

    [[bug]]
    name = "radius_rounded_down"
    file = "include/CGAL/L0_resampling/internal/search/ball_queries.h"
    find = 'std::ceil(radius / cell_size)'
    replace = 'std::floor(radius / cell_size)'

A row with several edits has a [[bug.edit]] with file, find and replace for each. `find` has to
occur exactly once in its file. Comments, blanks and line breaks do not matter outside string
literals, so that an edit outlives a reformatting of the file.
"""

import re
import tomllib
from dataclasses import dataclass
from pathlib import Path

LITERALS = r'R"\((?:.|\n)*?\)"|"(?:\\.|[^"\\\n])*"|' r"\d[\w.']*|'(?:\\.|[^'\\\n])*'"
C_COMMENTS = r"//[^\n]*|/\*(?:.|\n)*?\*/"
HASH_COMMENTS = r"\#[^\n]*"
REST = r"\w+|[^\w\s]"


class Edit_error(ValueError):
    """An edit that does not fit its file, or a table that is not well-formed."""


@dataclass(frozen=True)
class Edit:
    file: str    # relative to the root of the tree
    find: str
    replace: str


@dataclass(frozen=True)
class Row:
    name: str
    edits: tuple
    fields: dict    # the other keys of the row


def tokens_of(text, file):
    """Pairs of a token and its first character's place, without comments. Of a C++ operator, each
    character is a token."""
    has_hash_comments = Path(file).suffix in (".py", ".pyi", ".sh", ".cmake", ".txt", ".toml")
    comments = HASH_COMMENTS if has_hash_comments else C_COMMENTS
    pattern = re.compile(f"(?P<comment>{comments})|{LITERALS}|{REST}")
    return [(found.group(), found.start()) for found in pattern.finditer(text)
            if found.lastgroup != "comment"]


def places_of(find, text, file):
    """The pairs (begin, end) of `text` where `find` stands."""
    wanted = [token for token, _ in tokens_of(find, file)]
    if not wanted:
        raise Edit_error(f"{file}: nothing to find")
    tokens = tokens_of(text, file)
    words = [token for token, _ in tokens]
    places = []
    for first in range(len(words) - len(wanted) + 1):
        if words[first] == wanted[0] and words[first:first + len(wanted)] == wanted:
            last, begin_of_last = tokens[first + len(wanted) - 1]
            places.append((tokens[first][1], begin_of_last + len(last)))
    return places


def edited(text, edit):
    """`text`, which is that of the edit's file, after the edit."""
    places = places_of(edit.find, text, edit.file)
    if len(places) != 1:
        raise Edit_error(f"{edit.file}: found {len(places)} times instead of once: {edit.find}")
    begin, end = places[0]
    result = text[:begin] + edit.replace + text[end:]
    if result == text:
        raise Edit_error(f"{edit.file}: the edit changes nothing: {edit.find}")
    return result


def edited_files(tree, row):
    """Maps each file of the row, a path, to its text after the row's edits."""
    texts = {}
    for edit in row.edits:
        path = tree / edit.file
        if path not in texts:
            if not path.is_file():
                raise Edit_error(f"{edit.file}: no such file")
            texts[path] = path.read_text(encoding="utf-8")
        texts[path] = edited(texts[path], edit)
    return texts


class Applied:
    """Applies a row to a tree, and takes it back at the end of the `with` block."""

    def __init__(self, tree, row):
        self.texts = edited_files(tree, row)
        self.originals = {path: path.read_text(encoding="utf-8") for path in self.texts}

    def __enter__(self):
        for path, text in self.texts.items():
            path.write_text(text, encoding="utf-8")

    def __exit__(self, *_):
        for path, text in self.originals.items():
            path.write_text(text, encoding="utf-8")


def read_rows(path, key, required):
    """The rows [[`key`]] of a table, each of which has the keys `required` beside its edits."""
    with open(path, "rb") as stream:
        try:
            table = tomllib.load(stream)
        except tomllib.TOMLDecodeError as error:
            raise Edit_error(f"{path.name}: {error}") from error
    rows = []
    for entry in table.pop(key, []):
        name = entry.get("name", "a row without a name")
        edits = entry.pop("edit", [])
        if "file" in entry:
            edits = [{part: entry.pop(part, None) for part in ("file", "find", "replace")}, *edits]
        missing = [part for part in ("name", *required) if not entry.get(part)]
        if missing:
            raise Edit_error(f"{path.name}: {name} lacks {', '.join(missing)}")
        if not edits:
            raise Edit_error(f"{path.name}: {name} edits nothing")
        for edit in edits:
            if (edit.keys() != {"file", "find", "replace"}
                    or not all(isinstance(text, str) for text in edit.values())):
                raise Edit_error(f"{path.name}: an edit of {name} has not file, find and replace")
        rows.append(Row(name, tuple(Edit(**edit) for edit in edits), entry))
    if table:
        raise Edit_error(f"{path.name}: only [[{key}]] is known, not {', '.join(table)}")
    return rows


def faults_of(tree, rows):
    """A line for each row that does not fit the tree or has the name of another."""
    names = set()
    for row in rows:
        if row.name in names:
            yield f"{row.name}: there are two of this name"
        names.add(row.name)
        try:
            edited_files(tree, row)
        except Edit_error as error:
            yield f"{row.name}: {error}"
