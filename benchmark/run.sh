#!/usr/bin/env bash
# Reproduces the paper's tables and figures, as far as they can be measured, with every method that
# it names and its numbers of points. Takes most of an hour, and writes output/benchmark/report.md.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

[ $# = 0 ] || { echo "usage: run.sh" >&2; exit 2; }

scripts/install_dependencies.sh user
cmake -S . -B build -DCMAKE_BUILD_TYPE=Release -DPython_EXECUTABLE=/usr/bin/python3
cmake --build build -j "$(nproc)" --target benchmark_programs

/usr/bin/python3 -B benchmark/L0_resampling/report/make_report.py build output/benchmark \
                 --demo-data "$(scripts/fetch_demo_data.sh)"
