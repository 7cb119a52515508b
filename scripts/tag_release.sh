#!/usr/bin/env bash
# Makes a release of the commit that is checked out, once everything that it needs is there: the
# annotated tag v<version> and, in build/release, the archives of the sources and of the manual with
# their checksums. It pushes nothing.
#
#   scripts/tag_release.sh            says all that is missing, or makes archives and tag
#   scripts/tag_release.sh --dry-run  says all that is missing, or makes the archives alone
#
# For a release, set the version in CMakeLists.txt and where scripts/project_version.sh says, the
# date in the first section of CHANGES.md ("## 1.2.3, 2030-12-31") and, in CITATION.cff,
# `date-released`, `repository-code` and the authors. Then commit, and run scripts/test_all.sh, which
# builds the manual.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

if [ $# -gt 1 ] || { [ $# -eq 1 ] && [ "$1" != --dry-run ]; }; then
  echo "usage: scripts/tag_release.sh [--dry-run]" >&2
  exit 2
fi

missing=0
miss() {
  echo "tag_release.sh: $*" >&2
  missing=$((missing + 1))
}

version=$(scripts/project_version.sh) || miss "the versions do not agree"
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
manual=build/doc/L0_resampling/html
number=$(sed -nE 's/.*id="projectnumber">(&#160;)?([^<]*)<.*/\2/p' "$manual/index.html" \
             2> /dev/null || true)
if [ "$number" != "$version" ]; then
  miss "the manual in $manual is of version '$number': cmake --build build --target doc"
fi
[ "$missing" -eq 0 ] || exit 1

commit=$(git rev-parse --short HEAD)
name=cgal-l0-resampling-$version
mkdir -p build/release
git archive --prefix="$name/" HEAD | gzip -9n > "build/release/$name.tar.gz"
# The same bytes wherever it is packed
tar -c --sort=name --mtime="@$(git show -s --format=%ct HEAD)" --owner=0 --group=0 --numeric-owner \
    --mode=u+rw,go=rX --transform="s,^\.,$name-manual," -C "$manual" . \
  | gzip -9n > "build/release/$name-manual.tar.gz"
(cd build/release && sha256sum "$name.tar.gz" "$name-manual.tar.gz" | tee SHA256SUMS)
if [ "${1:-}" = --dry-run ]; then
  echo "would tag $commit as $tag"
else
  git tag --annotate "$tag" --message "CGAL L0 resampling $version"
  echo "tagged $commit as $tag; \"git push origin $tag\" publishes it"
fi
