#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares two lists that result_hashes printed: compare_result_hashes.py BEFORE AFTER

Prints each call whose result or report differs, and each that only one list has. Ends with 0 if
there is none, with 1 if there is, and with 2 if a file is no such list."""

import sys


def read_list(path):
    """The points and hashes of each call, by case, method and number of threads."""
    calls = {}
    with open(path, encoding="utf-8") as stream:
        for number, line in enumerate(stream, start=1):
            words = line.split()
            if len(words) != 6:
                raise ValueError(f"{path}, line {number}: not a line of result_hashes")
            name, method, threads, points, result, report = words
            calls[name, method, threads] = {"number of points": points, "result": result,
                                            "report": report}
    if not calls:
        raise ValueError(f"{path}: no line of result_hashes")
    return calls


def differences(before, after):
    for call in sorted(before.keys() | after.keys()):
        title = "{} by {} with {} thread(s)".format(*call)
        if call not in after:
            yield f"{title}: only before"
        elif call not in before:
            yield f"{title}: only after"
        else:
            changed = [what for what, value in before[call].items() if value != after[call][what]]
            if changed:
                yield f"{title}: another {' and '.join(changed)}"


def main():
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        return 2
    try:
        before, after = read_list(sys.argv[1]), read_list(sys.argv[2])
    except (OSError, ValueError) as error:
        print(error, file=sys.stderr)
        return 2
    found = list(differences(before, after))
    print("\n".join([*found, f"{len(before)} calls before, {len(after)} after, "
                             f"{len(found)} differ"]))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
