#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Looks whether the manual can be read without a network, wherever its folder lies:

  check_offline.py HTML_DIRECTORY [--formulas drawn|text]

- Scripts, styles, pictures and frames of the pages, and what their styles name, are files of the
  folder, under relative names.
- A page with formulas in TeX loads the MathJax of the folder. Formulas as text hold no TeX. With
  --formulas, the formulas of the whole manual are of that kind.
"""

import argparse
import re
import sys
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote

LOADED = {"script": "src", "img": "src", "iframe": "src", "source": "src", "link": "href"}
URL = re.compile(r"""url\(\s*["']?([^"')]+)|@import\s+["']([^"']+)""")
FORMULA = re.compile(r'<code class="l0Formula[^>]*>(.*?)</code>', re.DOTALL)
NOT_FILES = ("data:", "#", "javascript:void")


class Page(HTMLParser):
    """What a page loads, and its text."""

    def __init__(self, text):
        super().__init__()
        self.loaded, self.text, self.inside = [], [], []
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        attributes = dict(attributes)
        if attributes.get(LOADED.get(tag)):
            self.loaded.append(attributes[LOADED[tag]])
        self.add_urls(attributes.get("style") or "")
        if tag in ("script", "style", "code", "pre"):
            self.inside.append(tag)

    def handle_endtag(self, tag):
        if self.inside and self.inside[-1] == tag:
            self.inside.pop()

    def handle_data(self, text):
        if "style" in self.inside:
            self.add_urls(text)
        if not self.inside:
            self.text.append(text)

    def add_urls(self, style):
        self.loaded += [a or b for a, b in URL.findall(style)]


def not_in_folder(folder, place, name):
    """What is wrong with a name that a file in `place` loads, or None."""
    if name.startswith(NOT_FILES):
        return None
    if re.match(r"[a-zA-Z][a-zA-Z0-9+.-]*:|/", name):
        return "is no relative name"
    path = (place / unquote(re.split("[?#]", name)[0])).resolve()
    if not path.is_relative_to(folder) or not path.is_file():
        return "is not in the folder"
    return None


def errors_of_folder(folder, formulas):
    kinds = set()
    for path in sorted(folder.rglob("*")):
        if path.suffix == ".css":
            loaded = [a or b for a, b in URL.findall(path.read_text(encoding="utf-8"))]
        elif path.suffix == ".html":
            page = Page(path.read_text(encoding="utf-8"))
            loaded = page.loaded
            has_mathjax = any(name.endswith("/MathJax.js") for name in loaded)
            if re.search(r"\\[(\[]", "".join(page.text)):
                kinds.add("drawn")
                if not has_mathjax:
                    yield f"{path.name}: formulas in TeX, and no MathJax"
            for formula in FORMULA.findall(path.read_text(encoding="utf-8")):
                kinds.add("text")
                if "\\" in formula:
                    yield f"{path.name}: TeX is left in {formula}"
        else:
            continue
        for name in loaded:
            reason = not_in_folder(folder, path.parent, name)
            if reason:
                yield f"{path.name}: {name} {reason}"
    if formulas and kinds != {formulas}:
        yield f"formulas are {sorted(kinds)} instead of {formulas}"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("folder", type=Path)
    parser.add_argument("--formulas", choices=("drawn", "text"))
    arguments = parser.parse_args()
    folder = arguments.folder.resolve()
    errors = list(errors_of_folder(folder, arguments.formulas))
    if not (folder / "index.html").is_file():
        errors.append("there is no index.html")
    for error in errors:
        print("check_offline:", error, file=sys.stderr)
    sys.exit(1 if errors else 0)


if __name__ == "__main__":
    main()
