#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Results are current until a commit changes what they measure, and says not that it moves nothing:
test_measured.py SOURCE_DIRECTORY."""

import subprocess
import sys
import tempfile
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.append(str(Path(sys.argv[1]) / "benchmark" / "L0_resampling" / "common"))
import measured  # noqa: E402

NOTES = """
[kinds.quality]
trailer = "Results: same bits"
paths = ["method"]
[kinds.speed]
trailer = "Speed: same"
includes = ["quality"]
paths = ["search"]
[results]
"quality/a" = { kind = "quality", commit = "COMMIT" }
"speed/b" = { kind = "speed", commit = "COMMIT" }
"""


class Project:
    def __init__(self, root):
        self.root = root
        self.notes = root / "measured.toml"
        self.git("init", "-q", "-b", "main")

    def git(self, *arguments):
        return subprocess.run(
            ["git", "-C", self.root, "-c", "user.name=a", "-c", "user.email=a@b", *arguments],
            check=True, capture_output=True, text=True).stdout.strip()

    def commit(self, file, message):
        path = self.root / file
        path.parent.mkdir(exist_ok=True)
        path.write_text(path.read_text() + "x" if path.exists() else "x")
        self.git("add", "-A")
        self.git("commit", "-q", "-m", message)
        return self.git("rev-parse", "HEAD")

    def measure(self, *names):
        for name in names:
            measured.note(name, self.git("rev-parse", "HEAD")[:12], self.notes)

    def stale(self):
        """The first words of the sentences, and all of these as one text."""
        sentences = list(measured.stale_results(self.notes, self.root))
        return [sentence.split()[0] for sentence in sentences], "\n".join(sentences)


PAGE = r"""A table is in `quality/results/a.md`, a measure in `quality/results/shown.md`, at commit
\measured_quality_shown, and the other one in `speed/results/b.json`, see \measured_speed_bar."""


def check_names(root):
    """Pages that name a file of results show the commit."""
    manual = root / "doc" / "L0_resampling"
    manual.mkdir(parents=True)
    (root / "README.md").write_text("As `benchmark/speed/results/c.md` says.")
    (manual / "Page.txt").write_text(PAGE)
    named = {page.name: names for page, names in measured.named_results(root)}
    check("names of results are not found",
          named == {"README.md": {"speed/c"},
                    "Page.txt": {"quality/a", "quality/shown", "speed/b"}})
    wrong = [sentence.split()[:3] for sentence in
             measured.results_without_commit({"quality/a", "speed/c"}, root)]
    check("a page shows another commit", wrong == [["Page.txt", "names", "speed/b"]])


def check(what, is_right):
    if not is_right:
        sys.exit(f"test_measured: {what}")


def main():
    with tempfile.TemporaryDirectory() as folder:
        check_names(Path(folder) / "pages")
        root = Path(folder) / "project"
        root.mkdir()
        check("a folder of no repository has a history", not measured.has_history(root))
        project = Project(root)
        first = project.commit("method/fit", "First")
        project.notes.write_text(NOTES.replace("COMMIT", first[:12]))
        check("there is no history", measured.has_history(root))
        check("a folder of another project has its history",
              not measured.has_history(root / "method"))
        check("what was just measured is old", project.stale()[0] == [])
        project.commit("text", "Text")
        check("a text makes figures old", project.stale()[0] == [])

        project.commit("search/grid", "Grid")
        check("a search moves speed alone", project.stale()[0] == ["speed/b"])
        check("the commit is not named", "Grid" in project.stale()[1])
        project.measure("speed/b")
        check("measuring helps not", project.stale()[0] == [])

        project.commit("method/fit", "Fit\n\nA reason.\n\nResults: same bits\n")
        check("bits say nothing of speed", project.stale()[0] == ["speed/b"])
        project.commit("method/fit", "Speed\n\nSpeed: same\nResults: same bits as far as I know\n")
        names, text = project.stale()
        check("half a trailer is none", names == ["quality/a", "speed/b"])
        check("a commit is named that says all", "Fit" not in text.split("speed/b")[0])
        project.commit("text", f"Hashes\n\nResults: same bits since {first[:12]}\n")
        check("a trailer says nothing of the commits before it", project.stale()[0] == ["speed/b"])
        project.commit("method/fit", "Another method")
        check("it says something of those after it",
              project.stale()[0] == ["quality/a", "speed/b"])

        measured.note("quality/a", "0123456789ab", project.notes)
        check("a commit of elsewhere is taken", "no commit before" in project.stale()[1])
        measured.note("quality/a", first[:12] + measured.WITH_CHANGES, project.notes)
        check("uncommitted changes are taken", "with changes" in project.stale()[1])
        check("documents do not say so",
              measured.measured_at("quality/a", notes=project.notes)
              == f"Measured at commit `{first[:7]}{measured.WITH_CHANGES}`.")
        try:
            measured.note("quality/c", first, project.notes)
        except ValueError:
            return
        check("results of no name are noted", False)


if __name__ == "__main__":
    main()
