#!/usr/bin/env bash
# Builds the paper: test_paper.sh PAPER_DIRECTORY SCRATCH. All citations have to be found, and the
# Journal of Open Source Software asks for certain sections, and for 1000 words at most.
set -euo pipefail
paper=$1 scratch=$2

mkdir -p "$scratch"
cd "$paper"
failures=0
fail() {
  echo "$*" >&2
  failures=$((failures + 1))
}

pandoc --fail-if-warnings --standalone --citeproc --output "$scratch/paper.html" paper.md \
  || fail "pandoc does not build the paper"
for section in "Summary" "Statement of need" "State of the field" "Software design" \
               "Research impact statement" "AI usage disclosure" "Acknowledgements" "References"; do
  grep -q "^# $section\$" paper.md || fail "the paper has no section $section"
done
words=$(pandoc --to plain paper.md | wc -w)
[ "$words" -le 1000 ] || fail "the paper has $words words"
for entry in $(sed -nE 's/^@[a-z]+\{([^,]+),$/\1/p' paper.bib); do
  grep -qF "@$entry" paper.md || fail "paper.bib has $entry, which is not cited"
done
[ "$failures" -eq 0 ]
