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


def readers():
    """What was found by libFuzzer, a file for each corpus, and by the campaigns before the readers were as they are now."""
    runs = [json.loads(path.read_text(encoding="utf-8")) for path in sorted((HERE.parent / "fuzz" / "results").glob("*.json"))]
    earlier = [run for run in load("campaigns.json")["readers"] if run["corpus"] not in {run["corpus"] for run in runs}]
    times = [f"{run['executions']} {run['corpus']}" for run in runs] + [f"{run['executions']} {run['corpus']} (without other properties)" for run in earlier]
    return ", ".join(times), sum(run["broken"] for run in runs + earlier)


def attacks(promise):
    """Each campaign names the promises that it broke; what it found is mended, and in the corpus."""
    counts = {}
    campaigns = load("campaigns.json")["function"]
    for campaign in campaigns:
        counts[campaign["kind"]] = counts.get(campaign["kind"], 0) + campaign["attacks"]
    if any(sum(campaign["broke"].values()) != campaign["succeeded"] for campaign in campaigns):
        raise ValueError("campaigns.json does not say of each success which promise it broke")
    return ", ".join(f"{count} {name}" for name, count in counts.items()), sum(campaign["broke"].get(promise, 0) for campaign in campaigns)


def latency():
    """Of the runs with the most points, on one thread."""
    path = HERE.parents[2] / "benchmark" / "L0_resampling" / "performance" / "results" / "callback.json"
    runs = json.loads(path.read_text(encoding="utf-8"))["runs"]
    most = max(run["points_in"] for run in runs)
    of_most = [run for run in runs if run["points_in"] == most and run["threads"] == 1]
    calls = sum(run["calls"] for run in of_most)
    longest = max(run["busiest_gaps"][0]["cpu_seconds"] for run in of_most)
    ends = [end["cpu_seconds"] for run in of_most for end in run["cancellations"]]
    names = ", ".join(run["method"] for run in of_most)
    return (f"in each run of the tests; {calls} calls of the callback at {most} points ({names})",
            f"they pass; {1000 * longest:.0f} ms of processor time between two calls at most, and {1000 * max(ends):.0f} ms from `false` to the end")


def times_and_result(campaign, promise):
    if campaign is None:
        return "in each run of the tests", "they pass"
    if campaign == "latency":
        return latency()
    times, broken = readers() if campaign == "readers" else attacks(promise)
    return times, "none broken" if broken == 0 else f"{broken} broken, mended since"


def planted():
    """What `planted_bugs/run.sh --json` has found."""
    verdicts = load("planted_bugs_run.json")
    caught = [bug for bug, verdict in verdicts.items() if verdict.startswith("caught")]
    patches = list((HERE.parent / "planted_bugs").glob("*.patch"))
    lines = ["", "## Planted bugs", "",
             f"Of {len(patches)} patches in `test/L0_resampling/planted_bugs`, {len(verdicts)} were planted by its `run.sh` in this state of the tree; {len(caught)} were caught.", "",
             "| bug | verdict |", "| --- | --- |"]
    return lines + [f"| {bug} | {verdict} |" for bug, verdict in sorted(verdicts.items())]


def sanitized():
    lines = ["", "## Under sanitizers", "", "| what | result |", "| --- | --- |"]
    return lines + [f"| {run['program']} | {run['result']} |" for run in load("sanitized_runs.json")]


def main():
    lines = ["# The promises under attack", "",
             "Made by `test/L0_resampling/attack/promise_table.py` from the files in `results` beside it, and what the fuzzer and the benchmark of the callback have left. Every",
             "failure that was ever found is in `test/L0_resampling/attack/corpus` or `test/L0_resampling/fuzz/corpora`, which `ctest` replays.", "",
             "| promise | tests | what was tried | how many times | result |", "| --- | --- | --- | --- | --- |"]
    for row in load("promises.json"):
        times, result = times_and_result(row["campaign"], row["promise"])
        tests = ", ".join(f"`{test}`" for test in row["tests"])
        lines.append(f"| {row['promise']} | {tests} | {row['tried']} | {times} | {result} |")
    target = HERE.parents[2] / "doc" / "L0_resampling" / "promises_under_attack.md"
    target.write_text("\n".join(lines + planted() + sanitized()) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
