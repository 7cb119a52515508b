#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""What scripts/source_edits.py finds, replaces and refuses."""

import sys
import tempfile
import unittest
from pathlib import Path

sys.path.append(str(Path(__file__).resolve().parents[3] / "scripts"))
from source_edits import Applied, Edit, Edit_error, Row, edited, faults_of, read_rows

TEXT = """// f(a, b) of a comment
int x = f(a,   // the first
          b);
std::string s = "f(a, b)";
int million = 1'000'000, c = 'f';
"""


def after(find, replace, text=TEXT, file="some.h"):
    return edited(text, Edit(file, find, replace))


class Test_edits(unittest.TestCase):
    def test_blanks_line_breaks_and_comments_do_not_matter(self):
        for find in ("f(a, b)", "f(a,b)", "f (\n  a, b )", "f(a, /* second */ b)"):
            expected = TEXT.replace("f(a,   // the first\n          b)", "g()")
            self.assertEqual(after(find, "g()"), expected)

    def test_words_are_not_split(self):
        self.assertRaises(Edit_error, after, "in t x", "")
        self.assertRaises(Edit_error, after, "million = 1", "")    # of 1'000'000
        self.assertRaises(Edit_error, after, "ring s", "")

    def test_literals_are_exact(self):
        self.assertEqual(after('s = "f(a, b)"', 's = ""'), TEXT.replace('"f(a, b)"', '""'))
        self.assertRaises(Edit_error, after, 's = "f(a,b)"', "")

    def test_one_place_only(self):
        self.assertRaises(Edit_error, after, "int", "long")
        self.assertRaises(Edit_error, after, "of a comment", "")
        self.assertRaises(Edit_error, after, "", "x")
        self.assertRaises(Edit_error, after, "f(a, b)", "f(a,   // the first\n          b)")

    def test_comments_of_other_languages(self):
        self.assertEqual(after("x = 1", "x = 2", "x = 1  # x = 1\n", "some.py"), "x = 2  # x = 1\n")

    def test_applied_and_taken_back(self):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "some.h"
            file.write_text(TEXT, encoding="utf-8")
            row = Row("two", (Edit("some.h", "f(a, b)", "h"), Edit("some.h", "= h", "= g")), {})
            with Applied(Path(folder), row):
                self.assertIn("int x = g;", file.read_text(encoding="utf-8"))
            self.assertEqual(file.read_text(encoding="utf-8"), TEXT)

    def test_faults(self):
        with tempfile.TemporaryDirectory() as folder:
            table = Path(folder) / "bugs.toml"
            table.write_text("""[[bug]]
name = "absent"
test = "t"
file = "some.h"
find = 'x'
replace = 'y'
[[bug]]
name = "absent"
test = "t"
[[bug.edit]]
file = "bugs.toml"
find = 'nowhere'
replace = ''
""", encoding="utf-8")
            rows = read_rows(table, "bug", ["test"])
            faults = "\n".join(faults_of(Path(folder), rows))
            for words in ("no such file", "two of this name", "found 0 times"):
                self.assertIn(words, faults)
            for wrong in ("[[bug]]\nname = 'a'\n", "[[bugs]]\n",
                          "[[bug]]\nname = 'a'\ntest = 't'\n",
                          "[[bug]]\nname = 'a'\ntest = 't'\nfile = 'f'\n", "[[bug]"):
                table.write_text(wrong, encoding="utf-8")
                self.assertRaises(Edit_error, read_rows, table, "bug", ["test"])


if __name__ == "__main__":
    unittest.main()
