# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# [dask]
from pathlib import Path

from cgal_l0 import tiles
from distributed import Client, LocalCluster

if __name__ == "__main__":
    # two workers of this machine; Client(scheduler_file=FILE) joins a cluster that is there
    with LocalCluster(n_workers=2, threads_per_worker=1, dashboard_address=None) as cluster:
        with Client(cluster) as client:
            phases = tiles.resample_files(
                sorted(Path("survey").glob("*.ply")),
                "resampled",
                memory="1GB",  # of both
                workers=2,
                executor=client.get_executor(pure=False),
                options=["--points", "4000"],
                resume=Path("resampled").exists(),
            )
    # [dask]
    assert phases[-1]["name"] == "finish"
