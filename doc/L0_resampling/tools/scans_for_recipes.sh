#!/usr/bin/env bash
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Makes scans for the examples of the page Recipes, of shapes and scenes that are known:
#   scans_for_recipes.sh PROGRAMS DATA_DIRECTORY FOLDER
# PROGRAMS has scan_scene and sample_mesh; FOLDER gets the scans, and nothing else is left in it.
set -euo pipefail
programs=$(realpath "$1")
data=$(realpath "$2")
rm -rf "$3"
mkdir -p "$3"
cd "$3"

# A statue, here a ring, from one side, by a range camera
"$programs/scan_scene" "$data/torus.off" range --scanner range-camera --columns 160
# Photographs: noise, an uneven density, and points where there is nothing
"$programs/sample_mesh" "$data/bracket.off" photos.ply --points 16000 --noise 0.4 --outliers 3 \
  --density-gradient 4
# A street, by a lidar that turns on a car, from three places
"$programs/scan_scene" street survey --scanner spinning --views 3 --columns 300
# A machined part
"$programs/sample_mesh" "$data/bracket.off" part.ply --points 12000 --noise 0.3
# All sides of a smooth body
"$programs/scan_scene" "$data/torus.off" body --scanner range-camera --views 10 --columns 70
# The same stairs twice, once with a quarter of the points
"$programs/sample_mesh" "$data/staircase.off" first.ply --points 16000 --noise 0.3 --seed 1
"$programs/sample_mesh" "$data/staircase.off" second.ply --points 4000 --noise 0.3 --seed 2
mv survey_views.txt stations.txt
rm -- *_truth.off *_exact.ply *_views.txt
