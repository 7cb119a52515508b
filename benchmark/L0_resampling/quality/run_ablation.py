#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures what each ingredient of the default method gains.

Each row of ablation.toml switches one off, or puts the paper's form in its place. Rows are applied
one at a time to a temporary copy of the tree, where run_l0 alone is built: no switch of the library
serves the ablation only. LOR stands beside them. All variants get the same points, and each is
timed beside the whole method. The tables have the figures relative to the whole method's.
"""

import argparse
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import ablation_tables
from quality_bench import Bench, command_line, mesh_of, write_result

ROOT = Path(__file__).resolve().parents[3]
sys.path += [str(ROOT / "benchmark" / "L0_resampling" / "methods"), str(ROOT / "scripts")]
from methods import Method
from source_edits import Applied, Edit_error, faults_of, read_rows

# Shape, noise in %, share of outliers in %, density gradient: what each ingredient is for occurs once at least.
INPUTS = (("fandisk", 0.5, 0, 1), ("fandisk", 1, 0, 1), ("fandisk", 1.5, 0, 1), ("anchor_dense", 0.5, 5, 1),
          ("anchor_dense", 1.5, 10, 1), ("anchor_dense", 0.5, 0, 10), ("armadillo", 0.5, 0, 1),
          ("thin_plate", 0.5, 0, 1))


def read_ablations():
    return read_rows(Path(__file__).resolve().parent / "ablation.toml", "ablation", ["left"])


class Variant_builder:
    """Builds run_l0 from a copy of the tree."""

    def __init__(self, scratch):
        self.scratch, self.tree, self.build = scratch, scratch / "tree", scratch / "build"
        shutil.copytree(ROOT, self.tree, ignore=shutil.ignore_patterns(".git", "build*", "output"))
        off = ("BUILD_TOOL", "BUILD_TESTS", "BUILD_EXAMPLES", "WITH_PYTHON", "WITH_CUDA", "WITH_DOCUMENTATION",
               "INSTALL")
        launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
        self.call("cmake", "-S", self.tree, "-B", self.build, "-DCMAKE_BUILD_TYPE=Release",
                  *(f"-DCGAL_L0_{name}=OFF" for name in off), *launcher)

    def call(self, *command):
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        if done.returncode != 0:
            raise ValueError(f"{' '.join(map(str, command))} failed:\n{done.stdout}")

    def program(self, name):
        """The program of the tree as it is now, under a name of its own."""
        self.call("cmake", "--build", self.build, "--target", "run_l0")
        return shutil.copy(self.build / "bin" / "run_l0", self.scratch / f"run_l0_{name}")

    def edited_program(self, ablation):
        with Applied(self.tree, ablation):
            return self.program(ablation.name)


def variants_of(program_of):
    """Each variant's program and description; the whole method is the first.

    `program_of(name, ablation)` gives the program; for the whole method, the ablation is None.
    """
    variants = {"full": Method(program_of("full", None), ("--method", "default"))}
    descriptions = {"full": "the whole method"}
    for ablation in sorted(read_ablations(), key=lambda row: row.name):
        program = program_of(ablation.name, ablation)
        variants[ablation.name] = Method(program, ("--method", "default"))
        descriptions[ablation.name] = ablation.fields["left"]
    variants["lor"] = Method(variants["full"].program, ("--method", "lor"))
    descriptions["lor"] = "LOR, as it stands in the paper"
    return variants, descriptions


def build_variants(scratch):
    builder = Variant_builder(scratch)

    def program_of(name, ablation):
        print(f"building {name}", file=sys.stderr, flush=True)
        return builder.edited_program(ablation) if ablation else builder.program(name)

    return variants_of(program_of)


def find_variants(folder):
    return variants_of(lambda name, _: folder.resolve() / f"run_l0_{name}")


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path, help="build folder; its bin/ has the programs that sample and measure")
    parser.add_argument("meshes", type=Path, metavar="mesh_folder", help="has the meshes of libcgal-demo")
    parser.add_argument("--output", type=Path, metavar="FOLDER/NAME",
                        help="what to write, see common/results.py; else the tables are printed")
    parser.add_argument("--programs", type=Path, metavar="FOLDER",
                        help="has run_l0_full and a run_l0_NAME for each row; else they are built")
    parser.add_argument("--seeds", type=int, nargs="+", default=[1, 2, 3],
                        help="of the sampling; the tables show means")
    parser.add_argument("--input-points", type=int, default=12_000)
    parser.add_argument("--output-points", type=int, default=8_000)
    parser.add_argument("--threads", type=int, default=1)
    parser.add_argument("--timed-pairs", type=int, default=1, metavar="COUNT",
                        help="how often a variant and the whole method are timed side by side on each input")
    return parser.parse_args()


def main():
    arguments = parse_arguments()
    result = {"commands": [command_line("run_ablation.py", sys.argv[1:])], "experiments": []}
    with tempfile.TemporaryDirectory() as folder:
        scratch = Path(folder)
        bench = Bench(arguments.build.resolve() / "bin", scratch, arguments.threads)
        variants, result["variants"] = (find_variants(arguments.programs) if arguments.programs
                                        else build_variants(scratch))
        for shape, noise, outliers, gradient in INPUTS:
            for seed in arguments.seeds:
                mesh = mesh_of(shape, arguments.meshes)
                experiment = {"mesh": mesh.name, "noise_percent": noise, "outliers_percent": outliers,
                              "density_gradient": gradient, "seed": seed, "input_points": arguments.input_points,
                              "output_points": arguments.output_points, "measurements": {}}
                source = bench.sample(mesh, experiment)
                bench.measure_all(mesh, experiment, variants, lambda name, source=source: source)
                for name in variants.keys() - {"full"}:
                    experiment["measurements"][name]["relative_time"] = bench.relative_time(
                        source, variants[name], variants["full"], arguments.output_points, arguments.timed_pairs)
                result["experiments"].append(experiment)
                if arguments.output is not None:   # a long run that is cut short leaves what it has
                    write_result(arguments.output, result, ablation_tables.markdown(result))
    if arguments.output is None:
        write_result(arguments.output, result, ablation_tables.markdown(result))


if __name__ == "__main__":
    try:
        main()
    except (ValueError, OSError, subprocess.CalledProcessError) as error:
        sys.exit(f"run_ablation.py: {error}")
