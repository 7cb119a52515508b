#!/usr/bin/env bash
# Makes a release of the commit that is checked out: in build/release the archives of the sources
# and of the manual, the Debian package, a wheel, the tool for any Linux, the paper, and checksums
# of them; then the annotated tag v<version>. It pushes nothing.
#
#   scripts/tag_release.sh            makes nothing while something is missing that the commit needs,
#                                     and no tag unless all files were made
#   scripts/tag_release.sh --dry-run  makes all files that it can, and no tag
#
# Both say of each file what was made or why it was not, at the end what is missing, and have the
# status 1 if anything is. For a release, set the version in CMakeLists.txt and where
# scripts/project_version.sh says, the date in the first section of CHANGES.md
# ("## 1.2.3, 2030-12-31") and, in CITATION.cff, `date-released`, `repository-code` and the authors.
# Then commit, and run scripts/test_all.sh.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if [ $# -gt 1 ] || { [ $# -eq 1 ] && [ "$1" != --dry-run ]; }; then
  echo "usage: scripts/tag_release.sh [--dry-run]" >&2
  exit 2
fi
dry_run=${1:-}

missing=()
miss() { missing+=("$*"); }
end_if_missing() {
  [ ${#missing[@]} -gt 0 ] || return 0
  echo "tag_release.sh: this is missing for a release:" >&2
  printf -- '- %s\n' "${missing[@]}" >&2
  exit 1
}

version=$(scripts/project_version.sh) || miss "the versions do not agree, see above"
tag=v$version
date=$(sed -nE "s/^## ${version//./\\.}, ([0-9]{4}-[0-9]{2}-[0-9]{2})\$/\1/p" CHANGES.md)
[ -n "$date" ] || miss "CHANGES.md has no section \"## $version, YYYY-MM-DD\""
entries=$(sed "1,/^## ${version//./\\.},/d;/^## /,\$d" CHANGES.md | sed -n '/^- /p')
[ -n "$entries" ] || miss "the section $version of CHANGES.md has no entry"
released=$(sed -n 's/^date-released: "\(.*\)"$/\1/p' CITATION.cff)
if [ "$released" != "$date" ]; then
  miss "date-released of CITATION.cff is '$released', in CHANGES.md it is '$date'"
fi
if ! grep -qE '^repository-code: "?https://' CITATION.cff; then
  miss "CITATION.cff has no repository-code, a URL"
fi
[ -z "$(git status --porcelain)" ] || miss "there are changes that are not committed"
if git rev-parse -q --verify "refs/tags/$tag" > /dev/null; then
  miss "there is a tag $tag already"
fi
[ -n "$dry_run" ] || end_if_missing

export version
export name=cgal-l0-resampling-$version
export release=$PWD/build/release
export build=$PWD/build-package   # that of scripts/package.sh
# The same bytes whenever it is made
SOURCE_DATE_EPOCH=$(git show -s --format=%ct HEAD)
export SOURCE_DATE_EPOCH
logs=$PWD/build/release_logs
rm -rf "$release" "$logs"
mkdir -p "$release" "$logs"

make_sources() { git archive --prefix="$name/" HEAD | gzip -9n > "$release/$name.tar.gz"; }
make_programs() { scripts/package.sh programs; }
make_manual() {
  local pages=$build/doc/L0_resampling/html number
  cmake --build "$build" --target doc
  number=$(sed -nE 's/.*id="projectnumber">(&#160;)?([^<]*)<.*/\2/p' "$pages/index.html")
  if [ "$number" != "$version" ]; then
    echo "the manual in $pages is of version '$number'"
    exit 1
  fi
  tar -c --sort=name --mtime="@$SOURCE_DATE_EPOCH" --owner=0 --group=0 --numeric-owner \
      --mode=u+rw,go=rX --transform="s,^\.,$name-manual," -C "$pages" . \
    | gzip -9n > "$release/$name-manual.tar.gz"
}
make_debian_package() {
  rm -f "$build"/cgal-l0-resampling_*.deb   # those of other versions
  scripts/package.sh
  cp "$build"/cgal-l0-resampling_*.deb "$release"
}
make_wheel() {
  local platform
  sources=$(mktemp -d)
  trap 'rm -rf "$sources"' EXIT
  git archive HEAD | tar -x -C "$sources"
  platform=manylinux_$(getconf GNU_LIBC_VERSION | sed 's/.* //; s/\./_/')_$(uname -m)
  CGAL_L0_BUILD_DIRECTORY=$build CGAL_L0_WHEEL_PLATFORM=$platform /usr/bin/python3 -m pip wheel \
    --no-deps --no-index --no-build-isolation --wheel-dir "$release" "$sources"
}
make_portable_tool() {
  scripts/portable_tool.sh "$build" "$release/l0_resample-$version-linux-$(uname -m).tar.gz"
}
make_paper() {
  cd paper
  pandoc --fail-if-warnings --standalone --citeproc \
         --output "$release/$name-paper.html" paper.md
}
# make WHAT FILES PROGRAM...: calls make_WHAT, if the programs are there. It writes FILES, a pattern.
make() {
  local what=$1 files=$2 program reason="" log=$logs/$1.txt
  shift 2
  for program in "$@"; do
    command -v "$program" > /dev/null || reason="there is no $program"
  done
  # In a shell of its own: where a condition calls a function, set -e does not stop it.
  if [ -z "$reason" ] && ! bash -euo pipefail -c "$(declare -f "make_$what"); make_$what" \
                                < /dev/null > "$log" 2>&1; then
    reason="$(tail -n 1 "$log"), see $log"
  fi
  if [ -n "$reason" ]; then
    echo "$what: not made, $reason"
    miss "$what: $reason"
  else
    echo "$what: made$(cd "$release" && find . -name "$files" -printf ' %f')"
  fi
}
make sources "$name.tar.gz" git gzip
make programs "" cmake c++
make manual "$name-manual.tar.gz" cmake doxygen bibtex
make debian_package "*.deb" dpkg-deb lintian
make wheel "*.whl" /usr/bin/python3
make portable_tool "l0_resample-*.tar.gz" ldd strip
make paper "*-paper.html" pandoc
sums=$(cd "$release" && sha256sum -- *)   # before their own file is there
tee "$release/SHA256SUMS" <<< "$sums"

end_if_missing
commit=$(git rev-parse --short HEAD)
if [ -n "$dry_run" ]; then
  echo "would tag $commit as $tag"
else
  git tag --annotate "$tag" --message "CGAL L0 resampling $version"
  echo "tagged $commit as $tag; \"git push origin $tag\" publishes it"
fi
