#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Times l0_resample_point_set() beside CGAL's WLOP and EAR in one run.

Three experiments:
  comparison  one noisy set, on one thread all methods, ours also on two; ours interleaved with CGAL's
  scaling     cost of ours against the number of input points n, output 0.55 n
  solvers     what half-sampling saves with the paper's explicit rows, and with the block solver

Nothing is judged by its time. Every output file is checked: count, finite positions, unit normals.
"""

import argparse
import json
import math
import os
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

import performance_tables

sys.path += [str(Path(__file__).resolve().parents[1] / folder) for folder in ("common", "methods")]
from methods import EAR_EXAMPLE
from results import command_line, processor, write_result

METHODS = ("lor", "alor", "default")
OUTPUT_SHARE = 0.55
SCALING_COUNTS = (10_000, 30_000, 100_000, 300_000, 1_000_000, 3_000_000, 10_000_000)


def check_oriented_points(path, expected_count, exact):
    """Raises ValueError unless the binary PLY file at `path` holds finite positions and unit normals, all double.

    Edge-aware upsampling may stop early, so its count is an upper bound (`exact` false).
    """
    with open(path, "rb") as stream:
        count = None
        properties = []
        for line in iter(stream.readline, b""):
            words = line.split()
            if words[:2] == [b"element", b"vertex"]:
                count = int(words[2])
            elif words[:1] == [b"property"]:
                properties.append(words[1:])
            elif words == [b"end_header"]:
                break
        if properties != [[b"double", name] for name in (b"x", b"y", b"z", b"nx", b"ny", b"nz")]:
            raise ValueError(f"{path}: not a PLY file of positions and normals")
        data = stream.read()
    if count is None or len(data) != 48 * count:
        raise ValueError(f"{path}: {len(data)} bytes do not hold {count} points")
    if count != expected_count and (exact or not 0 < count < expected_count):
        raise ValueError(f"{path}: {count} points instead of {expected_count}")
    for index, values in enumerate(struct.iter_unpack("<6d", data)):
        if not all(map(math.isfinite, values)) or abs(math.hypot(*values[3:]) - 1) > 1e-6:
            raise ValueError(f"{path}: point {index} is not finite or its normal not of unit length: {values}")


class Bench:
    """Runs the programs of one build and keeps their output in one folder."""

    def __init__(self, programs, scratch):
        self.programs = programs
        self.scratch = scratch

    def sample(self, mesh, count, noise):
        path = self.scratch / f"{mesh.stem}_{count}_{noise:g}.ply"
        subprocess.run([self.programs / "sample_mesh", mesh, path, "--points", str(count), "--noise", str(noise),
                        "--seed", "1"], check=True, stdout=subprocess.DEVNULL)
        return path

    def run(self, program, source, points, *options, exact=True):
        """Runs `program`, checks the file it writes and returns the line of JSON it prints."""
        target = self.scratch / f"{program}.ply"
        command = [self.programs / program, source, target, "--points", str(points), *map(str, options)]
        line = json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True).stdout)
        check_oriented_points(target, points, exact)
        print(f"{program} {' '.join(map(str, options))}: {line['wall_seconds']:.3g} s", file=sys.stderr, flush=True)
        return line

    def run_l0(self, source, points, method, threads=1, solver="block"):
        return self.run("run_l0", source, points, "--method", method, "--threads", threads, "--solver", solver)


def compare(bench, source, points, repetitions, slow_repetitions):
    """CGAL's slow runs stand between the repetitions of ours, evenly, so that a change of the machine's load meets all."""
    between = [("wlop", "baseline_wlop", ()),
               ("ear", "baseline_ear", EAR_EXAMPLE),
               ("ear defaults", "baseline_ear", ())] * slow_repetitions
    runs = {}
    number_of_slow_runs = 0
    for repetition in range(repetitions):
        for method in METHODS:
            for threads in (1, 2):   # one after the other, as a machine's speed drifts
                runs.setdefault(f"{method}, {threads} threads" if threads > 1 else method, []).append(
                    bench.run_l0(source, points, method, threads))
        while number_of_slow_runs * repetitions < len(between) * (repetition + 1):
            name, program, options = between[number_of_slow_runs]
            runs.setdefault(name, []).append(bench.run(program, source, points, *options, exact=program != "baseline_ear"))
            number_of_slow_runs += 1
    return runs


def scale(bench, mesh, counts, noise, repetitions):
    runs = []
    for count in counts:
        source = bench.sample(mesh, count, noise)
        for method in METHODS:
            runs += [bench.run_l0(source, int(OUTPUT_SHARE * count), method) for _ in range(repetitions)]
        source.unlink()
    return runs


def compare_solvers(bench, mesh, count, noise, repetitions):
    source = bench.sample(mesh, count, noise)
    points = int(OUTPUT_SHARE * count)
    return [bench.run_l0(source, points, method, solver=solver)
            for _ in range(repetitions) for solver in ("block", "rows") for method in ("lor", "alor")]


def machine(build):
    """What decides speed: the processor, how many of it, how busy it is and how the programs were built."""
    cache = dict(line.split("=", 1) for line in (build / "CMakeCache.txt").read_text().splitlines()
                 if "=" in line and not line.startswith(("#", "//")))
    compiler = next(value for key, value in cache.items() if key.startswith("CMAKE_CXX_COMPILER:"))
    version = subprocess.run([compiler, "--version"], stdout=subprocess.PIPE, text=True).stdout.splitlines()[0]
    build_type = cache.get("CMAKE_BUILD_TYPE:STRING", "")
    flags = f"{cache.get('CMAKE_CXX_FLAGS:STRING', '')} {cache.get(f'CMAKE_CXX_FLAGS_{build_type.upper()}:STRING', '')}"
    return {"processor": processor(), "cores": os.cpu_count(), "load_average_before": os.getloadavg()[0],
            "compiler": version, "build_type": build_type, "flags": flags.strip()}


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path, help="build folder; its bin/ has the programs")
    parser.add_argument("mesh", type=Path, help="mesh to sample")
    parser.add_argument("--output", type=Path, metavar="FOLDER/NAME",
                        help="what to write, see common/results.py; else the tables are printed")
    parser.add_argument("--experiments", nargs="+", default=["comparison", "scaling", "solvers"],
                        choices=["comparison", "scaling", "solvers"])
    parser.add_argument("--noise", type=float, default=0.5, help="standard deviation, %% of the diagonal")
    parser.add_argument("--input-points", type=int, default=110_000, help="of the comparison")
    parser.add_argument("--output-points", type=int, default=60_000, help="of the comparison")
    parser.add_argument("--solver-input-points", type=int, default=10_000)
    parser.add_argument("--scaling-up-to", type=int, default=1_000_000, help="the counts go on to 10 million")
    parser.add_argument("--repetitions", type=int, default=5)
    parser.add_argument("--slow-repetitions", type=int, default=1, help="of CGAL's methods")
    parser.add_argument("--small", action="store_true", help="a few thousand points, every experiment, one repetition")
    arguments = parser.parse_args()
    if arguments.small:
        arguments.input_points, arguments.output_points, arguments.solver_input_points = 2_000, 1_100, 1_000
        arguments.repetitions = 1
    return arguments


def main():
    arguments = parse_arguments()
    counts = (1_000, 2_000) if arguments.small else [n for n in SCALING_COUNTS if n <= arguments.scaling_up_to]
    result = {"command": command_line("run_performance.py", sys.argv[1:]), "machine": machine(arguments.build),
              "mesh": arguments.mesh.name, "noise_percent": arguments.noise}
    with tempfile.TemporaryDirectory() as scratch:
        bench = Bench(arguments.build / "bin", Path(scratch))
        if "comparison" in arguments.experiments:
            source = bench.sample(arguments.mesh, arguments.input_points, arguments.noise)
            result["comparison"] = compare(bench, source, arguments.output_points, arguments.repetitions,
                                           arguments.slow_repetitions)
        if "scaling" in arguments.experiments:
            result["scaling"] = scale(bench, arguments.mesh, counts, arguments.noise, min(arguments.repetitions, 3))
        if "solvers" in arguments.experiments:
            result["solvers"] = compare_solvers(bench, arguments.mesh, arguments.solver_input_points, arguments.noise,
                                                min(arguments.repetitions, 3))
    write_result(arguments.output, result, performance_tables.markdown(result), performance_tables.figures(result))


if __name__ == "__main__":
    main()
