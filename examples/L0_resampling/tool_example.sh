#!/usr/bin/env bash
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# What one can do with the tool; run it where l0_resample is in the PATH:  tool_example.sh DATA_DIRECTORY
set -euo pipefail
data=$1

#! [tool]
# Half as many points, clean and oriented, with a picture of input and result
l0_resample "$data/bracket_noisy.ply" bracket.ply --percentage 50 --snapshot bracket.png

# The paper's method, a given number of points, and what was done, stage by stage
l0_resample "$data/bracket_noisy.ply" bracket_lor.ply --method lor --points 4000 --json bracket_lor.json
#! [tool]
