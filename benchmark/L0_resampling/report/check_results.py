#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that the tables of committed reports are those that their JSON gives: check_results.py REPORT.json... [--write]

With --write, REPORT.md is written anew. Exit status 77 if Debian's python3-matplotlib or python3-jinja2 is not installed.
"""

import argparse
import json
import sys
from pathlib import Path

try:
    import sections
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("reports", nargs="+", type=Path)
    parser.add_argument("--write", action="store_true")
    arguments = parser.parse_args()
    status = 0
    for report in arguments.reports:
        text = sections.markdown(sections.all_sections(json.loads(report.read_text(encoding="utf-8"))))
        tables = report.with_suffix(".md")
        if arguments.write:
            tables.write_text(text, encoding="utf-8")
        elif tables.read_text(encoding="utf-8") != text:
            print(f"{tables} is not what {report.name} gives; check_results.py --write {report} writes it anew", file=sys.stderr)
            status = 1
    return status


if __name__ == "__main__":
    sys.exit(main())
