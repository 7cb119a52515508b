#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes doc/L0_resampling/promises_under_attack.md from results/promises.json, what is tried where, results/campaigns.json, how often the
function was attacked and with what result, and ../fuzz/results, the same of the readers."""

import json
from pathlib import Path

HERE = Path(__file__).resolve().parent


def load(name):
    return json.loads((HERE / "results" / name).read_text(encoding="utf-8"))


def times_and_result(campaigns, kind):
    if kind is None:
        return "in each run of the tests", "they pass"
    if kind == "function":
        attacks = {}
        for campaign in campaigns[kind]:
            attacks[campaign["kind"]] = attacks.get(campaign["kind"], 0) + campaign["attacks"]
        times = ", ".join(f"{count} {name}" for name, count in attacks.items())
        broken = sum(c["succeeded"] for c in campaigns[kind])
    else:
        times = ", ".join(f"{c['executions']} {c['corpus']} ({c['executions_since_other_properties_are_read']} since other properties are read)" for c in campaigns[kind])
        broken = sum(c["broken"] for c in campaigns[kind])
    return times, "none broken" if broken == 0 else f"{broken} broken"


def main():
    campaigns = load("campaigns.json")
    lines = ["# The promises under attack", "",
             "Made by `test/L0_resampling/attack/promise_table.py` from the files in `results` beside it. Every failure that was ever found is in",
             "`test/L0_resampling/attack/corpus` or `test/L0_resampling/fuzz/corpora`, which `ctest` replays.", "",
             "| promise | tests | what was tried | how many times | result |", "| --- | --- | --- | --- | --- |"]
    for row in load("promises.json"):
        times, result = times_and_result(campaigns, row["campaign"])
        tests = ", ".join(f"`{test}`" for test in row["tests"])
        lines.append(f"| {row['promise']} | {tests} | {row['tried']} | {times} | {result} |")
    target = HERE.parents[2] / "doc" / "L0_resampling" / "promises_under_attack.md"
    target.write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
