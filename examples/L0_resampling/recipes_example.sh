#!/usr/bin/env bash
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# The recipes of the manual for the tool; run it in a folder with the scans, with l0_resample in the
# PATH. It replaces what an earlier run has left.
set -euo pipefail
rm -f -- *_clean.ply *_even.ply

#! [range]
l0_resample range.ply range_clean.ply --viewpoint 4.6,2.2,-3.3 --json range.json
#! [range]

#! [photos]
l0_resample photos.ply photos_clean.ply --points 8000 --snapshot photos.png --json photos.json
#! [photos]

#! [lidar]
l0_resample survey.ply survey_clean.ply --viewpoints stations.txt --view-property view \
  --json survey.json
#! [lidar]

#! [part]
l0_resample part.ply part_clean.ply --points 10000 --feature-confidence --json part.json
#! [part]

#! [poisson]
l0_resample body.ply body_clean.ply --percentage 100 --json body.json
#! [poisson]

#! [registration]
# The spacing of the scan with fewer points; from it, as many points for each as give that spacing
info() { l0_resample --info "$1" | awk -v name="$2:" '$1 == name { print $2 }'; }
spacing=$(info second.ply spacing)
for scan in first second; do
  percentage=$(awk "BEGIN { print 100 * ($(info $scan.ply spacing) / $spacing) ^ 2 }")
  l0_resample $scan.ply ${scan}_even.ply --percentage "$percentage"
done
#! [registration]
