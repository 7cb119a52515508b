#!/usr/bin/env bash
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
#
# What is made of the table of options of l0_resample: --help on one page, the man page, and the
# completions of bash, and tables for the manual, which all have the same options.
# usage: test_tool_manual.sh PROGRAM FOLDER PAGE
# FOLDER has the man page, the completions and tables of options; PAGE of the manual shows
# the tables.

manual=$(realpath "$2")
page=$(realpath "$3")
# shellcheck source-path=SCRIPTDIR
. "$(dirname "${BASH_SOURCE[0]}")/tool_checks.sh"

run --help
check "help" test "$status" -eq 0 -a ! -s stderr
# 93 lines of eight to the inch are a page of A4
check "help is one page" test "$(wc -l < stdout)" -le 93 -a "$(wc -l < stdout)" -gt 40
check "of 100 columns" test "$(awk 'length > 100' stdout | wc -l)" -eq 0
check "with groups" test "$(grep -c '^[A-Z][a-z ]*:$' stdout)" -ge 7
check "and three examples" test "$(sed '1,/^Examples:$/d' stdout | grep -c '^  l0_resample ')" -eq 3
options=$(grep -oE '^ +(-[a-zA-Z], )?--[a-z-]+' stdout | tr -d ' ' | tr ',' '\n' | sort)
check "the options of help" test "$(wc -w <<< "$options")" -ge 40
run -h
check "the short name of help" test "$status" -eq 0 -a "$(grep -c . stdout)" -gt 40
"$program" --help > /dev/full 2> stderr
check "help that cannot be written" test $? -eq 4

# Every option of the one is one of the others
in_man=$(sed 's/\\-/-/g; s/\\fR//g' "$manual/l0_resample.1" | grep '^\\fB-' \
  | grep -oE -- '-(-[a-z-]+|[a-zA-Z])\b' | sort)
check "the options of the man page" test "$in_man" = "$options"
in_bash=$(sed -n "/current == -/{n;s/.*-W '\(.*\)' --.*/\1/p}" "$manual/l0_resample" \
  | tr ' ' '\n' | sort)
check "the options of the completions" test "$in_bash" = "$options"

in_tables=$(sed 's/\\--/--/g' "$manual"/table_of_*_options.txt | grep -oE '<code>-[^<]*' \
  | sed 's/<code>//' | sort)
check "the options of the tables" test "$in_tables" = "$options"
tables=$(cd "$manual" && ls table_of_*_options.txt)
shown=$(sed -n "s/^.include{doc} //p" "$page" | sort)
check "the tables that the page shows" test "$shown" = "$tables"

if command -v groff > /dev/null; then
  groff -man -ww -z -Tutf8 "$manual/l0_resample.1" > stdout 2> stderr
  check "the man page is sound" test $? -eq 0 -a ! -s stderr
  groff -man -Tascii -P-cbu -rLL=100n "$manual/l0_resample.1" > stdout 2> stderr
  for text in '-n, --points M' 'NPY' 'EXIT STATUS' '.ply.gz' 'scans/\*.pcd'; do
    check "$text in the man page" grep -q -- "$text" stdout
  done
fi

# As bash asks for completions
compopt() { :; }   # which is for a shell with a user
# shellcheck disable=SC1091   # made by the build
. "$manual/l0_resample"
complete_words()   # the words, the last of which is completed; leaves COMPREPLY
{
  COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) COMPREPLY=()
  _l0_resample 2> stderr
}
mkdir pictures
complete_words l0_resample --neigh
check "an option" test "${COMPREPLY[*]}" = --neighbor-radius
complete_words l0_resample cub
check "a file" test "${COMPREPLY[*]}" = cube.xyz
complete_words l0_resample --method ""
check "methods" test "$(printf '%s\n' "${COMPREPLY[@]}" | sort | tr '\n' ' ')" = "alor default lor "
complete_words l0_resample cube.xyz --device c
check "devices" test "${COMPREPLY[*]}" = "cpu cuda"
complete_words l0_resample --output-format x
check "formats that are written" test "${COMPREPLY[*]}" = xyz
complete_words l0_resample --output-directory ""
check "a folder" test "${COMPREPLY[*]}" = pictures
complete_words l0_resample -o cu
check "the value of a short name" test "${COMPREPLY[*]}" = cube.xyz
complete_words l0_resample --points cu
check "a number is not completed" test "${#COMPREPLY[@]}" -eq 0
complete_words l0_resample --force cu
check "what is behind an option without a value" test "${COMPREPLY[*]}" = cube.xyz
check "the script registers itself" \
  test "$(complete -p l0_resample)" = "complete -F _l0_resample l0_resample"

end_of_checks
