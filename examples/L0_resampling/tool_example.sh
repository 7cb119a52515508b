#!/usr/bin/env bash
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What one can do with the tool; run it where l0_resample is in the PATH:
#   tool_example.sh DATA_DIRECTORY
# Results go to the folder tool_example.
set -euo pipefail
data=$(realpath "$1")
rm -rf tool_example   # of an earlier run
mkdir -p tool_example/scans
cd tool_example
cp "$data/bracket_noisy.ply" scan.ply
cp "$data/torus_noisy.ply" "$data/staircase_noisy.ply" scans
printf '0 0 5\n5 5 5\n' > stations.txt
# a hill with houses (class 6), of which each point has the number of the place it was seen from
awk 'BEGIN { print "x,y,z,classification,station"
             for (i = 0; i < 6000; ++i) {
               x = i % 75; y = int(i / 75); house = x % 25 > 18 && y % 27 > 20
               print x "," y "," 5 * sin(x / 20) + 4 * house "," (house ? 6 : 2) "," i % 2 } }' \
  > survey.csv

#! [one]
# Half as many points, clean and with normals, and a picture of input and result side by side
l0_resample scan.ply clean.ply --percentage 50 --snapshot clean.png

# A given number of points, by the method of the paper
l0_resample scan.ply lor.ply --points 4000 --method lor
#! [one]

#! [look]
# What a file holds, how noisy it is, and what a run would do
l0_resample --info scan.ply

# All checks of a run, without the run
l0_resample --dry-run scan.ply other.ply --points 2000
#! [look]

#! [many]
# Files and folders of files; what failed is listed at the end
l0_resample clean.ply scans --output-directory resampled --output-format pcd --points 1000
#! [many]

#! [convert]
# The points as they are, in another format, with all that the file tells of each point
l0_resample --convert-only survey.csv survey.las
#! [convert]

#! [text]
# A text whose columns are a point and a color: without names, only the point is read
awk 'NR > 1 { print $1, $2, $3, 255, 128, 0 }' FS=, survey.csv > orange.xyz
l0_resample orange.xyz orange.ply --columns x,y,z,red,green,blue
#! [text]

#! [pipe]
# From standard input to another program
l0_resample - - --input-format ply --output-format xyz < scan.ply | gzip > clean.xyz.gz
#! [pipe]

# Stands for LASzip, which need not be installed: what it compresses is text here.
mkdir bin
printf '#!/bin/sh\nbase64 -d "$2"\n' > bin/laszip
chmod +x bin/laszip
PATH=$PWD/bin:$PATH
base64 survey.las > survey.laz

#! [decompress]
# LAZ, through the program of LASzip
l0_resample survey.laz clean.las --decompress 'laszip -i {} -olas -stdout'
#! [decompress]

#! [survey]
# Of a survey only the ground, which is class 2; it was seen from above
l0_resample survey.las ground.las --keep-classes 2 --up 0,0,1
#! [survey]

#! [sides]
# Normals face the place of the scanner
l0_resample scan.ply seen.ply --viewpoint 2,3,4

# Several places: each point has the number of its line in stations.txt
l0_resample survey.csv merged.ply --viewpoints stations.txt --view-property station

# Normals on the side of those that the input has
l0_resample clean.ply turned.ply --orient-by-normals
#! [sides]

#! [properties]
# The nearest input point of each new point, and how sure it is that it lies on an edge
l0_resample scan.ply edges.ply --source-index --feature-confidence
#! [properties]

#! [report]
# What was done, in numbers; and no result if a linear system was not solved
l0_resample scan.ply strict.ply --json report.json --strict
#! [report]

#! [limits]
# A run that may not take more than this
l0_resample scan.ply modest.ply --max-points 100000 --max-memory 1GB --timeout 300 --threads 1
#! [limits]

#! [large]
# All files are parts of one cloud, which need not fit into memory: a file for each tile
l0_resample scans/*.ply --as-one --points 3000 --memory 1GB --output-directory tiles
#! [large]

#! [resume]
# The same after a crash: what is done already is kept
l0_resample scans/*.ply --as-one --points 3000 --memory 1GB --output-directory tiles --resume
#! [resume]

#! [config]
# Options that are always the same, in a file
printf 'points = 3000\nquiet = true\n' > settings.conf
l0_resample --config settings.conf scan.ply quiet.ply
#! [config]

#! [status]
# For scripts: the exit status tells what went wrong, here that there is no such file
status=0
l0_resample missing.ply nothing.ply || status=$?
[ "$status" -eq 3 ]

# What exists is not replaced, unless one says so
l0_resample scan.ply clean.ply || status=$?
[ "$status" -eq 4 ]
l0_resample scan.ply clean.ply --force
#! [status]
