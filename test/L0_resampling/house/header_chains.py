#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which headers can be compiled one after the other, and each as if it were alone:

  header_chains.py INCLUDE_DIRECTORY PREFIX HEADER...

A header may follow those that it includes anyway: they bring it nothing that it has not asked for.
So a chain, in which each header includes the one before it, is one source file with the verdict of
as many as the chain has headers.

PREFIX are headers of other projects, with commas between them. They may be precompiled before a
chain whose headers include all of them anyway. Prints as few chains as there can be of headers that
do, one a line after the word `prefix`, and of those that do not, after `alone`.
"""

import re
import sys
from pathlib import Path

INCLUDE = re.compile(r"^ *# *include <([^>]*)>", re.MULTILINE)


def included_headers(directory, headers):
    """What each of `headers` includes, directly or by others of them."""
    direct = {header: set(INCLUDE.findall((directory / header).read_text(encoding="utf-8")))
              for header in headers}
    closures = {}

    def closure(header):
        if header not in closures:
            closures[header] = direct[header].union(
                *(closure(other) for other in direct[header] & direct.keys()))
        return closures[header]

    for header in headers:
        closure(header)
    return closures


def find_chains(included):
    """Each header but the ends of chains is matched to the next: the most matches leave the fewest
    ends, and augmenting paths find them (Kuhn's algorithm)."""
    followers = {header: [other for other in included if header in included[other]]
                 for header in included}
    before = {}

    def augment(header, seen):
        for follower in followers[header]:
            if follower not in seen:
                seen.add(follower)
                if follower not in before or augment(before[follower], seen):
                    before[follower] = header
                    return True
        return False

    for header in included:
        augment(header, set())
    for end in sorted(included.keys() - before.values()):
        chain = [end]
        while chain[0] in before:
            chain.insert(0, before[chain[0]])
        yield chain


def main(directory, prefix, *headers):
    prefix = set(prefix.split(","))
    groups = {"prefix": {}, "alone": {}}
    for header, brought in included_headers(Path(directory), headers).items():
        groups["prefix" if prefix <= brought else "alone"][header] = brought
    for word, included in groups.items():
        for one in find_chains(included):
            print(word, *one)


if __name__ == "__main__":
    main(*sys.argv[1:])
