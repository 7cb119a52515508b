#!/usr/bin/env bash
# scripts/tag_release.sh in a repository of its own: test_tag_release.sh SOURCE_DIRECTORY SCRATCH
# What takes minutes there, and what a machine may lack, has stand-ins.
set -euo pipefail
source_directory=$1
scratch=$2

rm -rf "$scratch"
mkdir -p "$scratch"
cd "$source_directory"
manifest=packaging/vcpkg/cgal-l0-resampling/vcpkg.json
conda=packaging/conda/meta.yaml
consumer=test/L0_resampling/packages/consumer/CMakeLists.txt
cp --parents .gitignore CMakeLists.txt CHANGES.md CITATION.cff scripts/project_version.sh \
   scripts/tag_release.sh "$manifest" "$conda" "$consumer" "$scratch"
version=$(scripts/project_version.sh)   # which fails if they do not agree

cd "$scratch"
export GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_SYSTEM=/dev/null
export GIT_AUTHOR_NAME=test GIT_AUTHOR_EMAIL=test@example.org
export GIT_COMMITTER_NAME=test GIT_COMMITTER_EMAIL=test@example.org
git init -q .

failures=0
fail() {
  echo "$*" >&2
  failures=$((failures + 1))
}
commit() {
  git add --all
  git commit -q --allow-empty --message "$1"
}
# A sentence of the refusal, then a command that makes it necessary and is taken back afterwards.
refuses() {
  local sentence=$1 output
  shift
  "$@"
  if output=$(scripts/tag_release.sh 2>&1); then
    fail "tags although: $sentence"
  elif [[ $output != *"$sentence"* ]]; then
    fail "does not say '$sentence' but: $output"
  fi
  git tag --list | xargs -r git tag --delete > /dev/null
  git reset -q --hard good
}
edit() {
  sed -i "$2" "$1"
  commit "$1"
}

# The machine has all programs, but those that would take long do nothing.
stand_in() {   # stand_in FILE COMMANDS
  mkdir -p "$(dirname "$1")"
  printf '#!/bin/sh\n%s\n' "$2" > "$1"
  chmod +x "$1"
}
stand_in scripts/package.sh \
         '[ "$*" = programs ] || echo deb > build-package/cgal-l0-resampling_1.deb'
stand_in scripts/portable_tool.sh 'echo tool > "$2"'
cat > setup.py << 'END'
from setuptools import setup
setup(name="cgal_l0", version="1", py_modules=[])
END
mkdir -p paper build/machine
echo 'A paper.' > paper/paper.md
ln -s /usr/bin/* build/machine
for program in cmake c++ doxygen bibtex dpkg-deb lintian; do
  ln -sf /usr/bin/true build/machine/$program
done
rm -f build/machine/pandoc
stand_in build/machine/pandoc 'while [ "$1" != --output ]; do shift; done; cat paper.md > "$2"'
export PATH=$PWD/build/machine

# As a release has it
sed -i "s/^## $version,.*/## $version, 2030-12-31/" CHANGES.md
sed -i '/^date-released:/d; /^repository-code:/d' CITATION.cff
printf 'date-released: "2030-12-31"\nrepository-code: "https://example.org/l0"\n' >> CITATION.cff
commit good
git branch good
manual=build-package/doc/L0_resampling/html
mkdir -p $manual/search
write_manual() {
  echo "<span id=\"projectnumber\">&#160;$1</span>" > $manual/index.html
}
write_manual "$version"
echo all > $manual/search/all.js

refuses "not committed" touch new_file
rm -f new_file
refuses "not committed" sed -i 's/^# Changes/# News/' CHANGES.md
refuses "no section \"## $version, YYYY-MM-DD\"" \
        edit CHANGES.md "s/, 2030-12-31/, not released yet/"
refuses "has no entry" edit CHANGES.md 's/^- /  /'
refuses "date-released" edit CITATION.cff 's/2030-12-31/2030-12-30/'
refuses "repository-code" edit CITATION.cff '/^repository-code/d'
refuses "CITATION.cff has the version '0.0.7'" edit CITATION.cff 's/^version: .*/version: 0.0.7/'
refuses "vcpkg.json has the version" edit "$manifest" 's/"version": "/&9/'
refuses "meta.yaml has the version '0.0.7'" edit "$conda" 's/version = "[^"]*"/version = "0.0.7"/'
refuses "consumer/CMakeLists.txt has the version" edit "$consumer" 's/_resampling [0-9]/&7/'
refuses "CHANGES.md has the version '77.0.0'" edit CHANGES.md '3i ## 77.0.0, 2031-01-01\n'
refuses "no version of three numbers" edit CMakeLists.txt 's/VERSION [0-9]*\./VERSION /'
refuses "a tag v$version already" git tag "v$version"
refuses "is of version '77.0.0'" write_manual 77.0.0
refuses "manual: not made" rm $manual/index.html
write_manual "$version"

# A dry run makes what it can, and says what is missing at its end.
edit CITATION.cff '/^repository-code/d'
rm build/machine/lintian
mv build/machine/pandoc build/machine/pandoc_for_later
stand_in build/machine/pandoc 'echo "no such citation"; exit 1'
status=0
output=$(scripts/tag_release.sh --dry-run 2>&1) || status=$?
[ "$status" -eq 1 ] || fail "a dry run with something missing has the status $status"
for sentence in "debian_package: not made, there is no lintian" "manual: made cgal-" \
                "paper: not made, no such citation"; do
  [[ $output = *"$sentence"* ]] || fail "the dry run does not say '$sentence' but: $output"
done
[ "$(sed '1,/is missing for a release/d;s/:.*//' <<< "$output")" = \
  "- CITATION.cff has no repository-code, a URL
- debian_package
- paper" ] || fail "the list of what is missing is another one: $output"
ls build/release/*.deb build/release/*.html 2> /dev/null && fail "there are files of a failed part"
git reset -q --hard good
ln -s true build/machine/lintian
mv build/machine/pandoc_for_later build/machine/pandoc

scripts/tag_release.sh --nonsense 2> /dev/null && fail "takes any argument"
[ "$(scripts/tag_release.sh --dry-run | tail -1)" = \
  "would tag $(git rev-parse --short HEAD) as v$version" ] || fail "the dry run says something else"
[ -z "$(git tag --list)" ] || fail "the dry run has made a tag"
name=cgal-l0-resampling-$version
made=$(cd build/release && echo *)
for file in "$name.tar.gz" "$name-manual.tar.gz" "$name-paper.html" cgal-l0-resampling_1.deb \
            "l0_resample-$version-linux-$(uname -m).tar.gz"; do
  [[ " $made " = *" $file "* ]] || fail "there is no $file but $made"
done
[[ $made = *.whl* ]] || fail "there is no wheel but $made"
(cd build/release && sha256sum --check --quiet SHA256SUMS) || fail "the checksums are wrong"
tar -tzf "build/release/$name.tar.gz" | grep -x "$name/scripts/tag_release.sh" > /dev/null \
  || fail "the archive of the sources has no sources"
tar -tzf "build/release/$name-manual.tar.gz" | grep -x "$name-manual/search/all.js" > /dev/null \
  || fail "the archive of the manual has no manual"
touch --date=2001-01-01 $manual/index.html
cp build/release/SHA256SUMS build/first_time
scripts/tag_release.sh > /dev/null
cmp build/first_time build/release/SHA256SUMS || fail "another run makes other archives"
[ "$(git cat-file -t "v$version")" = tag ] || fail "the tag is not annotated"
[ "$(git rev-parse "v$version^{commit}")" = "$(git rev-parse HEAD)" ] \
  || fail "another commit is tagged"
[ "$failures" -eq 0 ]
