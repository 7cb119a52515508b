#!/usr/bin/env bash
# The archive of scripts/portable_tool.sh, in a root folder where there is nothing else:
#   test_portable_tool.sh SOURCE_DIRECTORY BUILD SCRATCH
set -euo pipefail
source_directory=$1 build=$2 scratch=$3
tool=$build/bin/l0_resample

change_root=(chroot)
if [ "$(id -u)" -ne 0 ]; then change_root=(unshare --map-root-user chroot); fi
mkdir -p "$scratch/empty"
if "${change_root[@]}" "$scratch/empty" /nothing 2>&1 | grep -q "ermitted\|denied"; then
  echo "this user cannot change the root folder"
  exit 77
fi

rm -rf "$scratch"
mkdir -p "$scratch/root/tmp"
"$source_directory/scripts/portable_tool.sh" "$build" "$scratch/portable.tar.gz"
tar -C "$scratch/root" -xzf "$scratch/portable.tar.gz"
licenses=$scratch/root/l0_resample/licenses
for license in libc6 libtbb12 LGPL-2.1 Apache-2.0; do
  [ -s "$licenses/$license" ]
done
# Those of headers that are compiled in: of packages, or of trees of sources
for text in GPL "Mozilla Public License" "Henry Schreiner" "Niels Lohmann"; do
  grep -rq "$text" "$licenses"
done
cp "$source_directory/data/bracket_noisy.ply" "$scratch/root"
loader=$(cd "$scratch/root" && ls l0_resample/lib/ld-*)
"${change_root[@]}" "$scratch/root" "/$loader" --library-path /l0_resample/lib \
  /l0_resample/lib/l0_resample /bracket_noisy.ply /out.ply --points 500
[ "$(head -c 3 "$scratch/root/out.ply")" = ply ]

# The script, from another folder and by a link, and with the same result as the tool itself
ln -s root/l0_resample/l0_resample "$scratch/link"
cd "$scratch"
./link root/bracket_noisy.ply by_link.ply --points 500
"$tool" root/bracket_noisy.ply by_tool.ply --points 500
cmp by_tool.ply by_link.ply
cmp by_tool.ply root/out.ply
# also where a processor has less
export GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX2
./link root/bracket_noisy.ply old_by_link.ply --points 500
"$tool" root/bracket_noisy.ply old_by_tool.ply --points 500
cmp old_by_tool.ply old_by_link.ply
# Nor is what runs on the processor of this machine alone packed for others.
mkdir native
echo "CGAL_L0_WITH_NATIVE_INSTRUCTIONS:BOOL=ON" > native/CMakeCache.txt
if "$source_directory/scripts/portable_tool.sh" native native.tar.gz 2> message; then
  echo "what was built for one processor is packed" >&2
  exit 1
fi
grep -q "for the processor of this machine" message
if ./link nothing.ply none.ply 2> message; then
  echo "the script loses the status" >&2
  exit 1
fi
