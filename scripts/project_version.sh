#!/usr/bin/env bash
# Prints the version of the project, which CMakeLists.txt has, and fails if a file that has to
# repeat it has another one.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

version=$(sed -nE 's/^project\(CGAL_L0_resampling VERSION ([0-9]+\.[0-9]+\.[0-9]+) .*/\1/p' \
              CMakeLists.txt)
if [ -z "$version" ]; then
  echo "CMakeLists.txt has no version of three numbers" >&2
  exit 1
fi

status=0
# The file, the version that it has to have, and a command of sed that prints it
expect() {
  local found
  found=$(sed -n "$3" "$1")
  if [ "$found" != "$2" ]; then
    echo "$1 has the version '$found', expected $2, as CMakeLists.txt has $version" >&2
    status=1
  fi
}
expect CITATION.cff "$version" 's/^version: //p'
expect packaging/vcpkg/cgal-l0-resampling/vcpkg.json "$version" 's/^  "version": "\(.*\)",$/\1/p'
expect packaging/conda/meta.yaml "$version" 's/^{% set version = "\(.*\)" %}$/\1/p'
expect test/L0_resampling/packages/consumer/CMakeLists.txt "${version%.*}" \
       's/^find_package(CGAL_L0_resampling \(.*\) REQUIRED)$/\1/p'
# the first section
expect CHANGES.md "$version" '/^## /{s/^## \([^,]*\),.*/\1/p;q}'
echo "$version"
exit "$status"
