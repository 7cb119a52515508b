# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Resamples a cloud of any size, tile by tile, on the workers of an executor.

    python3 -m cgal_l0.tiles FILES... --points M --output-directory D --memory 16GB --workers 4

Each task runs the program l0_resample with --as-one and --task, on files that all workers see. What
a worker that has died was at is done again; what memory was not enough for is not. In Python,
`resample_files()` takes any executor that has the interface of `concurrent.futures.Executor`.
"""

import argparse
import collections
import concurrent.futures
import contextlib
import os
import queue
import re
import shutil
import subprocess
import sys
import time

# How often a task is given to a worker again, after a worker has died or failed.
ATTEMPTS = 3

# Exit statuses of the program that would be the same another time: wrong usage, a refused input,
# not enough memory.
_REFUSALS = (2, 3, 6)

# Those of its options that go with tiles.
_OPTIONS = """points percentage output-format output input-format columns keep-classes decompress
    outlier-sensitivity neighbor-radius noise normal-weight sharpness-angle seed viewpoint up
    creases threads device halo""".split()
_FLAGS = "keep-density keep-outliers drop-non-finite first-returns force".split()

_UNITS = {"": 1, "K": 1 << 10, "M": 1 << 20, "G": 1 << 30, "T": 1 << 40}

# Tasks that take all of the memory that a worker, or a device, has got.
_TASKS_OF_TILES = (
    "scales:", "neighbors:", "balls:", "share:", "solve:", "carry:", "stitch:", "creases:"
)


class TileError(RuntimeError):
    """A task has failed; the message is that of the program."""


def bytes_of(size):
    """The number that a size such as 16G, 16GB or 16GiB stands for, in bytes."""
    match = re.fullmatch(r"\s*(\d+)\s*([KMGT]?)(I?B)?\s*", str(size).upper())
    if not match:
        raise ValueError(f"{size!r} is not a size, such as 16G")
    return int(match[1]) * _UNITS[match[2]]


def run_task(command, task, device=None):
    """What a worker does: runs one task, with one CUDA device if it is given, and gives what the
    program has written."""
    environment = None
    if device is not None:
        environment = {**os.environ, "CUDA_VISIBLE_DEVICES": str(device)}
    result = subprocess.run(
        [*command, "--task", task],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env=environment,
    )
    return task, result.returncode, result.stdout, result.stderr.strip()


class _Devices:
    """Lends each task that needs one a CUDA device of this machine, and no device to two."""

    def __init__(self, numbers):
        self._free = queue.Queue()
        for number in numbers:
            self._free.put(number)

    def run_task(self, command, task):
        # some need no device, but as much of the memory as a task with one
        if not task.startswith(_TASKS_OF_TILES):
            return run_task(command, task)
        device = self._free.get()
        try:
            return run_task(command, task, device)
        finally:
            self._free.put(device)


def _tasks_of(command):
    """The phases that are known so far: names and numbers of tasks."""
    _, status, output, error = run_task(command, "list")
    if status != 0:
        raise TileError(error)
    lines = [line.split() for line in output.splitlines()]
    return [(name, int(number)) for name, number in lines]


def _run_phase(executor, make_executor, run, command, tasks, on_done):
    """Runs the tasks of a phase by the function `run`. Gives the executor, which is another one if
    the old one broke, and the number of tasks that were given to it once more."""
    attempts = collections.Counter()
    retries = 0
    waiting = list(tasks)
    while waiting:
        futures = {executor.submit(run, command, task): task for task in waiting}
        failed = []
        is_broken = False
        for future in concurrent.futures.as_completed(futures):
            task = futures[future]
            attempts[task] += 1
            try:
                _, status, _, error = future.result()
            except concurrent.futures.BrokenExecutor as broken:
                is_broken, status, error = True, 1, str(broken)
            if status == 0:
                on_done(task)
            elif status in _REFUSALS or attempts[task] >= ATTEMPTS:
                for other in futures:
                    other.cancel()
                raise TileError(error or f"{task}: the program has ended with status {status}")
            else:
                failed.append(task)
        if is_broken and make_executor:
            executor.shutdown(wait=False)
            executor = make_executor()
        retries += len(failed)
        waiting = failed
    return executor, retries


def resample_files(
    files,
    output_directory,
    *,
    memory,
    options=(),
    executor=None,
    workers=1,
    devices=(),
    resume=False,
    program=None,
    on_progress=None,
):
    """Resamples the files as parts of one cloud, see `l0_resample --help`.

    memory            that all workers on one machine may take together, in bytes or as "16G".
                      What resamples tiles shares it out: the devices, if there are some, else the
                      workers. Workers that read the files take up to 1 GiB each then
    options           further options of the program, such as ["--points", "1000000"]
    executor          of the tasks; by default threads of this process, which wait for programs
    workers           tasks of one machine at a time
    devices           numbers of CUDA devices of this machine, such as [0, 1]: with --device cuda
                      among the options, tiles are resampled on all of them at a time. Without
                      them, a task takes the first device that it sees
    resume            go on where an earlier run has ended
    program           l0_resample, if it is not where the shell finds it
    on_progress       called with the name of a phase, the number of its tasks that are done, and
                      that of all

    Returns a list of phases: dictionaries of name, tasks, seconds and retries.
    """
    if devices and executor is not None:
        raise ValueError(
            "devices= is for workers of this process: others have devices of their own"
        )
    program = program or os.environ.get("L0_RESAMPLE") or shutil.which("l0_resample")
    if not program:
        raise TileError("l0_resample is not found; program= or L0_RESAMPLE can name it")
    command = [
        os.fspath(program),
        *map(os.fspath, files),
        "--as-one",
        "--output-directory",
        os.fspath(output_directory),
        "--memory",
        str(bytes_of(memory) // (len(devices) or workers)),
        *map(str, options),
    ]
    if resume:
        command.append("--resume")

    def make_threads():
        return concurrent.futures.ThreadPoolExecutor(workers)

    run = _Devices(devices).run_task if devices else run_task
    own = executor is None
    executor = make_threads() if own else executor
    phases = []
    try:
        _, status, _, error = run_task(command, "begin")
        if status != 0:
            raise TileError(error)
        known = _tasks_of(command)
        while len(phases) < len(known):
            name, number = known[len(phases)]
            done = 0

            def on_done(_):
                nonlocal done
                done += 1
                if on_progress:
                    on_progress(name, done, number)

            start = time.monotonic()
            tasks = [f"{name}:{k}" for k in range(number)]
            executor, retries = _run_phase(
                executor, make_threads if own else None, run, command, tasks, on_done
            )
            phases.append(
                {
                    "name": name,
                    "tasks": number,
                    "seconds": time.monotonic() - start,
                    "retries": retries,
                }
            )
            if len(phases) == len(known) and name != "finish":
                known = _tasks_of(command)  # the tiles are known now
    finally:
        if own:
            executor.shutdown(cancel_futures=True)
    return phases


def _print_progress(name, done, number):
    end = "\n" if done == number else ""
    print(f"\r\033[K{name} {done} of {number}", end=end, file=sys.stderr, flush=True)


@contextlib.contextmanager
def _executor_of(arguments):
    if arguments.dask:
        from distributed import Client

        with Client(scheduler_file=arguments.dask) as client:
            yield client.get_executor(pure=False)
    elif arguments.mpi:
        from mpi4py.futures import MPIPoolExecutor

        with MPIPoolExecutor() as executor:
            yield executor
    else:
        yield None


def _devices_of(arguments):
    if not arguments.devices:
        return []
    if arguments.device != "cuda":
        raise ValueError("--devices needs --device cuda")
    return [int(number) for number in arguments.devices.split(",")]


def main(arguments=None):
    """The command line. Gives the exit status."""
    parser = argparse.ArgumentParser(
        prog="python3 -m cgal_l0.tiles", description="Resamples files as parts of one cloud."
    )
    parser.add_argument("files", nargs="+", metavar="FILES")
    parser.add_argument("--output-directory", required=True, metavar="FOLDER")
    parser.add_argument("--memory", required=True, help="of all workers of a machine, as 16G")
    parser.add_argument("--workers", type=int, default=1, help="tasks of a machine at a time")
    parser.add_argument(
        "--devices", metavar="NUMBERS", help="CUDA devices of --device cuda, such as 0,1"
    )
    parser.add_argument("--resume", action="store_true", help="go on with an earlier run")
    parser.add_argument("--dask", metavar="FILE", help="the scheduler file of a Dask cluster")
    parser.add_argument("--mpi", action="store_true", help="the processes of mpi4py.futures")
    parser.add_argument("--program", help="l0_resample")
    of_program = parser.add_argument_group("options of l0_resample")
    for name in _OPTIONS:
        of_program.add_argument(f"--{name}", metavar="VALUE")
    for name in _FLAGS:
        of_program.add_argument(f"--{name}", action="store_true")
    known = parser.parse_intermixed_args(arguments)
    options = []
    for name in _OPTIONS + _FLAGS:
        value = getattr(known, name.replace("-", "_"))
        if value is True:
            options.append(f"--{name}")
        elif value:
            options.append(f"--{name}={value}")
    try:
        with _executor_of(known) as executor:
            phases = resample_files(
                known.files,
                known.output_directory,
                memory=known.memory,
                options=options,
                executor=executor,
                workers=known.workers,
                devices=_devices_of(known),
                resume=known.resume,
                program=known.program,
                on_progress=_print_progress if sys.stderr.isatty() else None,
            )
    except (TileError, ValueError) as error:
        print(error, file=sys.stderr)
        return 1
    seconds = sum(phase["seconds"] for phase in phases)
    retries = sum(phase["retries"] for phase in phases)
    print(f"{known.output_directory}: {seconds:.2f} s, {retries} tasks done once more")
    return 0


if __name__ == "__main__":
    sys.exit(main())
