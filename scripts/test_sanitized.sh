#!/usr/bin/env bash
# Builds and runs the tests under sanitizers: test_sanitized.sh [asan|tsan]..., both if none is named. Takes several times as long as scripts/test.sh;
# the tests *_asan and *_tsan of every build are a small selection.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

scripts/install_dependencies.sh
presets=("$@")
[ $# -gt 0 ] || presets=(asan tsan)
for preset in "${presets[@]}"; do
  cmake --preset "$preset"
  cmake --build --preset "$preset" -j "$(nproc)"
  ctest --preset "$preset" -j "$(nproc)"
done
