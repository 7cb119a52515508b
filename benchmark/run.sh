#!/usr/bin/env bash
# Reproduces the paper's tables and figures, with every method that it names, and ends in one page: output/benchmark/report.html.
#
#   run.sh            a twentieth of the paper's numbers of points
#   run.sh --full     the paper's numbers of points
#
# With --resume, an interrupted run goes on where it was.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

selection=small
options=()
for word in "$@"; do
  case "$word" in
    --full) selection=full ;;
    --resume) options+=("$word") ;;
    *) echo "usage: run.sh [--full] [--resume]" >&2; exit 2 ;;
  esac
done

scripts/install_dependencies.sh user python3-matplotlib python3-jinja2 libjs-three
cmake -S . -B build -DCMAKE_BUILD_TYPE=Release -DPython_EXECUTABLE=/usr/bin/python3
cmake --build build -j "$(nproc)" --target benchmark_programs

options+=(--demo-data "$(scripts/fetch_demo_data.sh)")
/usr/bin/python3 -B benchmark/L0_resampling/report/make_report.py build output/benchmark --selection "$selection" "${options[@]}"
