#!/usr/bin/env bash
# Installs what the package alone needs, builds it in the folder build-core and runs its tests: for
# changes of include/ or of the compiled libraries. Ends with ctest's summary.
exec "$(dirname "${BASH_SOURCE[0]}")/test.sh" core
