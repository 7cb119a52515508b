#!/usr/bin/env bash
# Packs the tool with all that it loads, the C library too, so that it runs on any Linux of this
# architecture, whatever it has installed:
#
#   scripts/portable_tool.sh BUILD ARCHIVE.tar.gz     BUILD is a folder that CMake was told to build
#                                                     without native instructions
#
# The archive has the folder l0_resample: the program in it, a script, needs /bin/sh alone. A static
# program would be one file, as those for other systems are (cmake/foreign_system.cmake). But it has
# no loader, and that chooses the library of the stages for the instructions of the processor, from
# the folders glibc-hwcaps/x86-64-v3 and -v4: a static program runs those of all x86-64 processors.
set -euo pipefail
if [ $# -ne 2 ]; then
  sed -n '2,/^set /{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}" >&2
  exit 2
fi
build=$(readlink -f "$1")
tool=$build/bin/l0_resample
archive=$(readlink -f "$2")
source_directory=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

if grep -qE '^CGAL_L0_WITH_NATIVE_INSTRUCTIONS:BOOL=(ON|1|TRUE|YES|Y)$' "$build/CMakeCache.txt"; then
  echo "portable_tool.sh: $build is compiled for the processor of this machine, and the archive is for" \
       "others too: configure it with -DCGAL_L0_WITH_NATIVE_INSTRUCTIONS=OFF." >&2
  exit 1
fi

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
folder=$scratch/l0_resample
mkdir -p "$folder/lib"
cp "$source_directory/LICENSE" "$folder"
install -m 755 "$tool" "$folder/lib/l0_resample"
strip "$folder/lib/l0_resample"
# "name => path (address)", and the loader, which has a path alone
if ldd "$tool" | grep "not found"; then exit 1; fi
mapfile -t libraries < <(ldd "$tool" | sed -nE 's,^[^/]*(/[^ ]*) \(0x.*,\1,p')
foreign=()   # those of others
for library in "${libraries[@]}"; do
  if [[ $library != */libCGAL_L0_* ]]; then foreign+=("$library"); fi
  # The loader has chosen for this processor; another one may need another.
  place=${library%/*} name=${library##*/}
  place=${place%/glibc-hwcaps/*}
  cp -L "$place/$name" "$folder/lib"
  for other in "$place"/glibc-hwcaps/*/"$name"; do
    if [ -e "$other" ]; then
      install -D -m 644 "$other" "$folder/lib/${other#"$place/"}"
    fi
  done
done
mapfile -t headers < "$build/headers_of_others.txt"
"$source_directory/scripts/library_licenses.sh" "$folder/licenses" "${foreign[@]}" "${headers[@]}"
loader=$(basename "$(ldd "$tool" | sed -nE 's,^\s*(/[^ ]*) \(0x.*,\1,p')")

cat > "$folder/l0_resample" << END
#!/bin/sh
here=\$(dirname "\$(readlink -f "\$0")")/lib
exec "\$here/$loader" --argv0 "\$0" --library-path "\$here" "\$here/l0_resample" "\$@"
END
chmod 755 "$folder/l0_resample"
tar -c --owner=0 --group=0 --numeric-owner -C "$scratch" l0_resample | gzip -9n > "$archive"
echo "$archive: $(du -h "$archive" | cut -f1)"
