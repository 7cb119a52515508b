#!/usr/bin/env bash
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# Resamples files as parts of one cloud on the nodes of a Slurm cluster:
#   slurm_example.sh POINTS MEMORY_OF_A_TASK FOLDER FILES...
# All nodes have to see the files, the folder and l0_resample under the same names. Where a run has
# ended too early, the same command goes on.
set -euo pipefail
points=$1 memory=$2 folder=$3
shift 3

#! [slurm]
run=(l0_resample "$@" --as-one --points "$points" --memory "$memory" --output-directory "$folder")
[ ! -e "$folder" ] || run+=(--resume)
"${run[@]}" --task begin

# The first phase that is not in $done, and the number of its tasks
next_phase() {
  "${run[@]}" --task list | while read -r phase tasks; do
    [[ $done == *" $phase "* ]] || { echo "$phase $tasks"; break; }
  done
}

done=" "
while read -r phase tasks < <(next_phase); do
  # an array of jobs for each phase, one job a task
  sbatch --wait --job-name="$phase" --array="0-$((tasks - 1))" --mem="$memory" \
         --wrap="$(printf '%q ' "${run[@]}") --task $phase:\$SLURM_ARRAY_TASK_ID"
  done+="$phase "
done
#! [slurm]
