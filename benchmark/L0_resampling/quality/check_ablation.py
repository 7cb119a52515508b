#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that each row of ablation.toml fits the source tree."""

import sys

from run_ablation import ROOT, Edit_error, faults_of, read_ablations

if __name__ == "__main__":
    try:
        ablations = read_ablations()
        faults = list(faults_of(ROOT, ablations))
    except (Edit_error, OSError) as error:
        sys.exit(f"check_ablation.py: {error}")
    print("\n".join([*faults, f"{len(ablations)} ablations, {len(faults)} faults"]))
    sys.exit(1 if faults or not ablations else 0)
