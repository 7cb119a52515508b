#!/usr/bin/env bash
# Makes and tests the package of Conan with the CGAL, Eigen and TBB that the system has, in folders
# that are removed afterwards. Needs conan 2.4 or later, and no network. Arguments go to
# `conan create`.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"

CONAN_HOME=$(mktemp -d)
export CONAN_HOME
trap 'rm -rf "$CONAN_HOME" test_package/CMakeUserPresets.json' EXIT
conan profile detect
cat >> "$CONAN_HOME/profiles/default" <<'END'
[platform_requires]
cgal/5.5.1
eigen/3.4.0
onetbb/2021.8.0
END
conan create . --no-remote --conf="tools.cmake.cmake_layout:test_folder=$CONAN_HOME/test" "$@"
