#!/usr/bin/env bash
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# What one can do with the tool; run it where l0_resample is in the PATH:  tool_example.sh DATA_DIRECTORY
set -euo pipefail
data=$1
rm -rf bracket.ply bracket_lor.ply bracket.pcd bracket.xyz smaller   # of an earlier run

#! [tool]
# Half as many points, clean and oriented, with a picture of input and result
l0_resample "$data/bracket_noisy.ply" bracket.ply --percentage 50 --snapshot bracket.png

# The paper's method, a given number of points, and what was done, stage by stage
l0_resample "$data/bracket_noisy.ply" bracket_lor.ply --method lor --points 4000 --json bracket_lor.json

# Many files, or folders of them, at once; what failed is listed at the end
l0_resample bracket.ply bracket_lor.ply --output-directory smaller --points 1000

# The points as they are in another format, with all that the file tells of each
l0_resample --convert-only bracket.ply bracket.pcd

# As a filter. The output of another program is not replaced: a file that exists needs --force
l0_resample - - --input-format pcd --output-format xyz < bracket.pcd > bracket.xyz

# A text whose columns are no normals behind the coordinates
awk '{ print $1, $2, $3, 255, 128, 0 }' bracket.xyz > orange.xyz
l0_resample --force orange.xyz bracket.ply --columns x,y,z,red,green,blue
#! [tool]
