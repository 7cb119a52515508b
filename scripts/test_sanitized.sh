#!/usr/bin/env bash
# Builds and runs the tests under sanitizers: test_sanitized.sh [asan|tsan]..., both if none is
# named. A part of scripts/test_all.sh, and takes several times as long as scripts/test.sh. The few
# tests *_asan and *_tsan are others: they are compiled for the processor of this machine.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/install_dependencies.sh
presets=("$@")
[ $# -gt 0 ] || presets=(asan tsan)
for preset in "${presets[@]}"; do
  cmake -G Ninja --preset "$preset" -DPython3_EXECUTABLE=/usr/bin/python3
  cmake --build --preset "$preset" -j "$(nproc)"
  ctest --preset "$preset" -j "$(nproc)"
done
