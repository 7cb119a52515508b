#!/usr/bin/env bash
# Makes the annotated tag v<version> of the commit that is checked out, once everything that a
# release needs is there; it pushes nothing.
#
#   scripts/tag_release.sh            says all that is missing, or makes the tag
#   scripts/tag_release.sh --dry-run  says all that is missing, or what it would do
#
# For a release, set the version in CMakeLists.txt and where scripts/project_version.sh says, the
# date in the first section of CHANGES.md ("## 1.2.3, 2030-12-31") and, in CITATION.cff,
# `date-released`, `repository-code` and the authors. Then commit, and run scripts/test_all.sh.
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
[ "$missing" -eq 0 ] || exit 1

commit=$(git rev-parse --short HEAD)
if [ "${1:-}" = --dry-run ]; then
  echo "would tag $commit as $tag"
else
  git tag --annotate "$tag" --message "CGAL L0 resampling $version"
  echo "tagged $commit as $tag; \"git push origin $tag\" publishes it"
fi
