#!/usr/bin/env bash
# Unpacks the data of Debian's libcgal-demo to output/demo_data, unless it is there, and prints its folder: meshes and real scans.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

demo_data=output/demo_data
if [ ! -d "$demo_data/data" ]; then
  # Unpacked rather than installed: minimal Debian systems leave out the folder that the package puts its data in.
  mkdir -p "$demo_data"
  (cd "$demo_data" && apt-get -o APT::Sandbox::User=root download -qq libcgal-demo >&2 && dpkg-deb -x libcgal-demo_*.deb unpacked)
  tar -xzf "$demo_data/unpacked/usr/share/doc/libcgal-dev/data.tar.gz" -C "$demo_data"
  rm -r "$demo_data/unpacked" "$demo_data"/libcgal-demo_*.deb
fi
echo "$demo_data/data"
