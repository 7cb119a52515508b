# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""Clouds that are resampled tile by tile: executors, workers that fail, and refusals."""

import concurrent.futures
import json
import os
import pathlib
import shutil
import subprocess
import sys

import numpy
import pytest

from cgal_l0 import tiles

# what the program takes anyway, and what some 12000 points with half as many samples do
MEMORY = (96 << 20) + 12000 * 340


@pytest.fixture(scope="module")
def files(tmp_path_factory):
    """A wavy ribbon in two files."""
    folder = tmp_path_factory.mktemp("ribbon")
    random = numpy.random.default_rng(2)
    x, y = numpy.mgrid[0:2400, 0:10].reshape(2, -1) + random.uniform(-0.5, 0.5, (2, 24000))
    points = numpy.stack([x, y, 2 * numpy.sin(x / 40) + random.uniform(-0.05, 0.05, 24000)], 1)
    names = [folder / "a.npy", folder / "b.npy"]
    numpy.save(names[0], points[:9000])
    numpy.save(names[1], points[9000:])
    return names


def run_program(files, folder):
    command = [os.environ["L0_RESAMPLE"], *files, "--as-one", "--points", "12000"]
    command += ["--memory", str(MEMORY), "--output-directory", folder, "--quiet"]
    subprocess.run([str(word) for word in command], check=True)


@pytest.fixture(scope="module")
def whole(files):
    """What the program gives by itself."""
    folder = files[0].parent / "whole"
    run_program(files, folder)
    return folder


def results(folder):
    return {path.name: path.read_bytes() for path in pathlib.Path(folder).glob("tile_*.ply")}


def resample(files, folder, workers=1, **arguments):
    return tiles.resample_files(
        files, folder, memory=workers * MEMORY, workers=workers, options=["--points", "12000"],
        **arguments,
    )


@pytest.mark.parametrize("workers", [1, 2])
def test_workers_give_what_the_program_gives(files, whole, tmp_path, workers):
    steps = []
    phases = resample(
        files, tmp_path / "out", workers, on_progress=lambda *step: steps.append(step)
    )
    assert results(tmp_path / "out") == results(whole) != {}
    assert phases[-1]["name"] == "finish" and sum(phase["retries"] for phase in phases) == 0
    assert ("solve", len(results(whole)), len(results(whole))) in steps


def test_workers_carry_properties(files, tmp_path):
    tables = [tmp_path / "a.csv", tmp_path / "b.csv"]
    for name, table in zip(files, tables):
        points = numpy.load(name)
        kinds = numpy.arange(len(points))[:, None] % 7
        numpy.savetxt(table, numpy.hstack([points, kinds]), ["%.17g"] * 3 + ["%d"], ",",
                      header="x,y,z,kind", comments="")
    run_program(tables, tmp_path / "whole")
    phases = resample(tables, tmp_path / "out", workers=2)
    assert "carry" in [phase["name"] for phase in phases]
    assert results(tmp_path / "out") == results(tmp_path / "whole") != {}
    assert b"property int kind\n" in results(tmp_path / "out")["tile_0.ply"]


def test_an_executor_of_the_caller(files, whole, tmp_path):
    with concurrent.futures.ProcessPoolExecutor(2) as executor:
        resample(files, tmp_path / "out", executor=executor)
        assert executor.submit(abs, -1).result() == 1  # it is still the caller's
    assert results(tmp_path / "out") == results(whole)


def test_a_program_that_dies_is_run_again(files, whole, tmp_path):
    program = tmp_path / "dies_once"
    program.write_text(
        "#!/bin/sh\n"
        f'case "$*" in *solve:1*) mkdir "{tmp_path}/died" 2> /dev/null && kill -KILL $$;; esac\n'
        f'exec "{os.environ["L0_RESAMPLE"]}" "$@"\n'
    )
    program.chmod(0o755)
    phases = resample(files, tmp_path / "out", program=program)
    assert results(tmp_path / "out") == results(whole)
    assert {p["name"]: p["retries"] for p in phases if p["retries"]} == {"solve": 1}


def test_a_run_goes_on(files, whole, tmp_path):
    program = tmp_path / "always_dies"
    program.write_text(
        "#!/bin/sh\n"
        'case "$*" in *solve:2*) kill -KILL $$;; esac\n'
        f'exec "{os.environ["L0_RESAMPLE"]}" "$@"\n'
    )
    program.chmod(0o755)
    with pytest.raises(tiles.TileError, match="solve:2"):
        resample(files, tmp_path / "out", program=program)
    with pytest.raises(tiles.TileError, match="earlier run"):
        resample(files, tmp_path / "out")
    resample(files, tmp_path / "out", resume=True)
    assert results(tmp_path / "out") == results(whole)


def command_line(files, folder):
    command = [*files, "--points", "12000", "--memory", 2 * MEMORY, "--workers", 2]
    return [str(word) for word in [*command, "--output-directory", folder]]


def test_the_command_line(files, whole, tmp_path):
    command = [sys.executable, "-m", "cgal_l0.tiles", *command_line(files, tmp_path / "out")]
    command += ["--output", str(tmp_path / "all.npy")]
    result = subprocess.run(command, capture_output=True, text=True)
    assert result.returncode == 0, result.stderr
    assert result.stdout.count("\n") == 1 and result.stderr == ""
    assert results(tmp_path / "out") == results(whole)
    assert numpy.load(tmp_path / "all.npy").shape == (12000, 6)
    index = json.loads((tmp_path / "out/index.json").read_text())
    assert sum(tile["output_points"] for tile in index["tiles"]) == 12000


def test_a_dask_cluster(files, whole, tmp_path):
    distributed = pytest.importorskip("distributed")
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, dashboard_address=None
    ) as cluster, distributed.Client(cluster) as client:
        client.write_scheduler_file(tmp_path / "scheduler.json")
        command = ["--dask", str(tmp_path / "scheduler.json")]
        assert tiles.main([*command_line(files, tmp_path / "out"), *command]) == 0
        ran = client.run(lambda dask_worker: dask_worker.state.executed_count)
    assert results(tmp_path / "out") == results(whole)
    assert len(ran) == 2 and sum(ran.values()) > len(results(whole))


def test_processes_of_mpi(files, whole, tmp_path):
    pytest.importorskip("mpi4py")
    if not shutil.which("mpiexec"):
        pytest.skip("no mpiexec")
    command = ["mpiexec", "--oversubscribe", "-n", "3", sys.executable, "-m", "mpi4py.futures"]
    command += ["-m", "cgal_l0.tiles", *command_line(files, tmp_path / "out"), "--mpi"]
    as_root = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1"}
    result = subprocess.run(
        command, env={**os.environ, **as_root}, capture_output=True, text=True
    )
    assert result.returncode == 0, result.stderr
    assert results(tmp_path / "out") == results(whole)


def test_arrays_of_slurm(files, whole, tmp_path):
    """The example, with a program that runs the jobs of an array as Slurm does: in any order."""
    programs = tmp_path / "programs"
    programs.mkdir()
    (programs / "l0_resample").symlink_to(os.environ["L0_RESAMPLE"])
    sbatch = programs / "sbatch"
    sbatch.write_text(
        "#!/bin/bash\n"
        'for word in "$@"; do case "$word" in\n'
        '  --array=0-*) last="${word#--array=0-}";;\n'
        '  --wrap=*) job="${word#--wrap=}";;\n'
        "esac; done\n"
        f'echo "$(( last + 1 ))" >> "{tmp_path}/arrays"\n'
        "for (( k = last; k >= 0; --k )); do\n"
        '  SLURM_ARRAY_TASK_ID="$k" sh -c "$job" || exit 1\n'
        "done\n"
    )
    sbatch.chmod(0o755)
    example = pathlib.Path(os.environ["L0_SOURCE"]) / "examples/L0_resampling/slurm_example.sh"
    command = ["bash", example, "12000", MEMORY, tmp_path / "out", *files]
    path = f"{programs}{os.pathsep}{os.environ['PATH']}"
    for _ in range(2):  # the second time there is nothing left to do
        subprocess.run(
            [str(word) for word in command], env={**os.environ, "PATH": path}, check=True
        )
    assert results(tmp_path / "out") == results(whole)
    assert str(len(results(whole))) in (tmp_path / "arrays").read_text().split()


def test_devices_are_lent_to_one_task_at_a_time(tmp_path):
    program = tmp_path / "notes_its_device"
    program.write_text(
        "#!/bin/sh\n"
        'device="$CUDA_VISIBLE_DEVICES"\n'
        'case "$*" in\n'
        '*list) for phase in "count 2" "scales 1" "neighbors 6" "balls 6" "share 6" "solve 6"'
        ' "carry 6" "stitch 1" "finish 1"; do echo "$phase"; done;;\n'
        "*count:*) sleep 0.1;;\n"
        "*scales:*|*neighbors:*|*balls:*|*share:*|*solve:*|*carry:*|*stitch:*)"
        f' mkdir "{tmp_path}/used_$device" && sleep 0.1'
        f' && rmdir "{tmp_path}/used_$device" && echo "$device" >> "{tmp_path}/devices";;\n'
        "esac\n"
    )
    program.chmod(0o755)
    phases = tiles.resample_files(
        [], tmp_path / "out", memory="1G", workers=4, devices=[3, 5], program=program
    )
    assert [phase["retries"] for phase in phases] == 9 * [0]
    used = (tmp_path / "devices").read_text().split()
    assert len(used) == 32 and set(used) == {"3", "5"}
    with pytest.raises(ValueError, match="of their own"):
        with concurrent.futures.ThreadPoolExecutor(1) as executor:
            tiles.resample_files([], tmp_path / "out", memory="1G", devices=[0], executor=executor)


def test_lack_of_memory_is_not_tried_again(tmp_path):
    program = tmp_path / "needs_memory"
    program.write_text(
        "#!/bin/sh\n"
        'case "$*" in\n'
        '*list) echo "solve 1";;\n'
        f'*solve:0) echo tried >> "{tmp_path}/tries"; echo "not enough memory" >&2; exit 6;;\n'
        "esac\n"
    )
    program.chmod(0o755)
    with pytest.raises(tiles.TileError, match="not enough memory"):
        tiles.resample_files([], tmp_path / "out", memory="1G", program=program)
    assert (tmp_path / "tries").read_text() == "tried\n"


def test_refusals(files, tmp_path):
    with pytest.raises(tiles.TileError, match="missing"):
        resample([tmp_path / "missing.npy"], tmp_path / "out")
    with pytest.raises(ValueError, match="not a size"):
        tiles.resample_files(files, tmp_path / "out", memory="much")
    assert tiles.main([str(files[0]), "--memory", "1G", "--output-directory",
                       str(tmp_path / "out"), "--devices", "0"]) == 1
    assert tiles.main([*command_line(files, tmp_path / "out"), "--halo", "0"]) == 1
    assert not (tmp_path / "out").exists()


def test_sizes():
    assert tiles.bytes_of("16G") == tiles.bytes_of("16GiB") == tiles.bytes_of("16 gb") == 16 << 30
    assert tiles.bytes_of(12345) == 12345
