#!/usr/bin/env bash
# Reproduces the paper's tables and figures, with every method that it names, and ends in one page: output/benchmark/report.html.
#
#   run.sh            a tenth of the paper's numbers of points
#   run.sh --full     the paper's numbers of points
#   run.sh --smoke    as few points as make sense, on our own shapes: shows that everything runs
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

case "${1:-}" in
  "") selection=small ;;
  --full | --smoke) selection=${1#--} ;;
  *) echo "usage: run.sh [--full | --smoke]" >&2; exit 2 ;;
esac

scripts/install_dependencies.sh python3-matplotlib python3-jinja2 libjs-three
cmake -S . -B build -DCMAKE_BUILD_TYPE=Release -DPython_EXECUTABLE=/usr/bin/python3
cmake --build build -j "$(nproc)" --target benchmark_programs

demo_data=()
if [ "$selection" != smoke ]; then
  demo_data=(--demo-data "$(scripts/fetch_demo_data.sh)")
fi
/usr/bin/python3 -B benchmark/L0_resampling/report/make_report.py build output/benchmark --selection "$selection" "${demo_data[@]}"
