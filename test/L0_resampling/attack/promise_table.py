#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes doc/L0_resampling/promises_under_attack.md from results/promises.json, what is tried where, results/campaigns.json, how often the
function was attacked and with what result, results/device_runs.json, what was run on a device, ../fuzz/results, the same of the readers, and what the benchmarks of callback and tool have left."""

import csv
import json
import tomllib
from pathlib import Path

HERE = Path(__file__).resolve().parent
MEASURED = HERE.parents[2] / "benchmark" / "L0_resampling" / "performance" / "results"


def load(name):
    return json.loads((HERE / "results" / name).read_text(encoding="utf-8"))


def readers():
    """What was found by libFuzzer, a file for each corpus."""
    runs = [json.loads(path.read_text(encoding="utf-8")) for path in sorted((HERE.parent / "fuzz" / "results").glob("*.json"))]
    return ", ".join(f"{run['executions']} {run['corpus']}" for run in runs), result_of(sum(run["broken"] for run in runs))


def result_of(broken):
    return "none broken" if broken == 0 else f"{broken} broken, mended since"


def attacks(promise):
    """Each campaign names the promises that it broke, and the code that it attacked; what it found is mended, and in the corpus."""
    counts = {}
    campaigns = load("campaigns.json")["function"]
    for campaign in campaigns:
        what = f"{campaign['kind']}, on {campaign['code']}"
        counts[what] = counts.get(what, 0) + campaign["attacks"]
    known = {row["promise"] for row in load("promises.json")} | {"none"}
    if any(sum(campaign["broke"].values()) != campaign["succeeded"] or not known.issuperset(campaign["broke"]) for campaign in campaigns):
        raise ValueError("campaigns.json does not say of each success which promise it broke")
    return "; ".join(f"{count} {what}" for what, count in counts.items()), result_of(sum(campaign["broke"].get(promise, 0) for campaign in campaigns))


def remarks():
    """What the campaigns found that broke no promise."""
    return [f"Of {campaign['attacks']} attacks from seed {campaign['seed']}, {campaign['remark']}." for campaign in load("campaigns.json")["function"]
            if "remark" in campaign]


def measured(name):
    return json.loads((MEASURED / f"{name}.json").read_text(encoding="utf-8"))["runs"]


def latency():
    """Of each method with the most points it was run with."""
    runs = measured("callback")
    most = {}
    for run in runs:
        most[run["method"]] = max(most.get(run["method"], 0), run["points_in"])
    times, results = [], []
    for run in runs:
        if run["points_in"] < most[run["method"]]:
            continue
        threads = "1 thread" if run["threads"] == 1 else f"{run['threads']} threads"
        times.append(f"{run['calls']} calls of the callback at {run['points_in']} points by {run['method']} on {threads}")
        gap = max(gap["cpu_seconds"] for gap in run["busiest_gaps"])
        ends = [end["cpu_seconds"] for end in run["cancellations"]]
        results.append(f"{1000 * gap:.0f} ms between two calls and {1000 * max(ends):.0f} ms from `false` to the end by {run['method']} on {threads}")
    return ("in each run of the tests; " + ", ".join(times), "they pass; at most, in processor time of all threads, " + ", ".join(results))


def memory():
    """Bytes a point on one thread, beside an index and two numbers for each pair of self neighbors."""
    peaks = {}
    for run in measured("callback"):
        if run["threads"] == 1:
            peaks.setdefault(run["method"], []).append((run["points_in"], run["peak_bytes"], run["peak_bytes"] - 12 * run["self_neighbor_pairs"]))
    cells = [f"{peak / points:.0f} ({beside / points:.0f} beside the lists of neighbors) at {points} by {method}"
             for method, runs in peaks.items() for points, peak, beside in sorted(runs)]
    return "in each run of the tests; " + str(len(cells)) + " clouds of up to ten million points", "they pass; bytes a point: " + ", ".join(cells)


def streaming():
    runs = measured("tool_streaming")
    if not all(run["is_monotonic"] for run in runs):
        raise ValueError("the progress of reading falls")
    times = ", ".join(f"{run['points']} points of {run['file']}" for run in runs)
    return times, ", ".join(f"{run['file']}: progress drawn {len(run['shares'])} times while it is read, and never falls; {run['peak_bytes'] / run['points']:.0f} bytes a point at most"
                            for run in runs)


def times_and_result(campaign, promise):
    if campaign is None:
        return "in each run of the tests", "they pass"
    if campaign in MEASUREMENTS:
        return MEASUREMENTS[campaign]()
    return readers() if campaign == "readers" else attacks(promise)


MEASUREMENTS = {"latency": latency, "memory": memory, "streaming": streaming}


def planted():
    """What `planted_bugs.py run --record` has found."""
    folder = HERE.parent / "planted_bugs"
    with open(folder / "verdicts.csv", encoding="utf-8", newline="") as stream:
        verdicts = list(csv.DictReader(stream))
    bugs = {bug["name"] for path in folder.glob("*.toml") for bug in tomllib.loads(path.read_text(encoding="utf-8"))["bug"]}
    if not bugs.issuperset(row["bug"] for row in verdicts):
        raise ValueError(f"there are verdicts on bugs that are not there: {sorted({row['bug'] for row in verdicts} - bugs)}")
    caught = sum(row["verdict"].startswith("caught") for row in verdicts)
    return ["", "## Planted bugs", "",
            f"Of {len(bugs)} bugs in `test/L0_resampling/planted_bugs`, {len(verdicts)} were planted, and {caught} of these were caught; `verdicts.csv` there says on which code."]


def sanitized():
    """What of the presets `asan` and `tsan` was run, beside the tests named `*_asan` and `*_tsan`, which are in each run of the tests."""
    lines = ["", "## Under sanitizers", "",
             "In each run of the tests: `attack_asan`, `attack_asan_corpus`, `attack_tsan`, `attack_tsan_large`, and `test_parallel_for` and `test_search_grid` "
             "under both. `scripts/test_sanitized.sh` runs the whole suite; of that, this was run:", "",
             "| what | on | result |", "| --- | --- | --- |"]
    return lines + [f"| {run['program']} | {run['code']} | {run['result']} |" for run in load("sanitized_runs.json")]


def on_device():
    """What the continuous integration, which has no device, skips."""
    lines = ["", "## On a device", "",
             "The tests `test_cuda_*` are skipped where there is no device. On one, and under the tools of `compute-sanitizer`, with the smallest clouds:", "",
             "| what | device, code | result |", "| --- | --- | --- |"]
    return lines + [f"| {run['program']} | {run['device']}, {run['code']} | {run['result']} |" for run in load("device_runs.json")]


def main():
    lines = ["# The promises under attack", "",
             "Made by `test/L0_resampling/attack/promise_table.py` from the files in `results` beside it, and what the fuzzer and the benchmark of the callback have left. Every",
             "failure that was ever found is in `test/L0_resampling/attack/corpus` or `test/L0_resampling/fuzz/corpora`, which `ctest` replays.", "",
             "| promise | tests | what was tried | how many times | result |", "| --- | --- | --- | --- | --- |"]
    for row in load("promises.json"):
        times, result = times_and_result(row["campaign"], row["promise"])
        tests = ", ".join(f"`{test}`" for test in row["tests"])
        lines.append(f"| {row['promise']} | {tests} | {row['tried']} | {times} | {result} |")
    lines += ["", *remarks()]
    target = HERE.parents[2] / "doc" / "L0_resampling" / "promises_under_attack.md"
    target.write_text("\n".join(lines + planted() + sanitized() + on_device()) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
