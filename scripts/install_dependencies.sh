#!/usr/bin/env bash
# Installs from Debian 12 what building and testing needs and the machine lacks, and the packages that are named.
set -euo pipefail

packages=(g++ cmake make git python3 libcgal-dev libeigen3-dev libtbb-dev libboost-dev libgmp-dev libmpfr-dev
          libcli11-dev nlohmann-json3-dev libpng-dev zlib1g-dev libceres-dev)
packages+=(pybind11-dev python3-dev python3-numpy python3-pytest mypy)   # for the Python package
packages+=(python3-pip python3-setuptools python3-wheel)            # for its wheel
packages+=(python3-distributed python3-mpi4py openmpi-bin)          # for workers of other engines
packages+=(dpkg-dev file)                                           # for the Debian package
packages+=(doxygen texlive-binaries libjs-mathjax)                  # for the manual
packages+=("$@")
missing=()
for package in "${packages[@]}"; do
  [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || missing+=("$package")
done
[ ${#missing[@]} -gt 0 ] || exit 0

as_root=()
[ "$(id -u)" -eq 0 ] || as_root=(sudo)
echo "Installing: ${missing[*]}"
"${as_root[@]}" apt-get update -qq
DEBIAN_FRONTEND=noninteractive "${as_root[@]}" apt-get install -y -qq --no-install-recommends "${missing[@]}"
