#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Which headers can be compiled one after the other, and each as if it were alone:

  header_chains.py INCLUDE_DIRECTORY HEADER...

A header may follow those that it includes anyway: they bring it nothing that it has not asked for.
So a chain, in which each header includes the one before it, is one source file with the verdict of
as many as the chain has headers. Prints as few chains as there can be, one a line.
"""

import re
import sys
from pathlib import Path

INCLUDE = re.compile(r"^ *# *include <(CGAL/(?:L0_resampling/|l0_)[^>]*)>", re.MULTILINE)


def included_headers(directory, headers):
    """What each of `headers` includes of them, directly or not."""
    direct = {header: set(INCLUDE.findall((directory / header).read_text(encoding="utf-8")))
              for header in headers}
    closures = {}

    def closure(header):
        if header not in closures:
            found = direct[header] & direct.keys()
            closures[header] = found.union(*(closure(other) for other in found))
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


if __name__ == "__main__":
    for one in find_chains(included_headers(Path(sys.argv[1]), sys.argv[2:])):
        print(" ".join(one))
