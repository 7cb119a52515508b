#!/usr/bin/env python3
# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""The commits that results were measured at which documents quote, as measured.toml notes them:

  measured.py              says which of these results are older than the code that they measure, and
                           for which commits; exit status 1 if there are any
  measured.py NAME COMMIT  notes that results such as performance/fandisk were measured at a commit,
                           for what another machine has measured, where there is no history

Without the history of the project, as in a release, it says so and ends with status 77.
"""

import re
import subprocess
import sys
import tomllib
from pathlib import Path

BENCHMARK = Path(__file__).resolve().parents[1]
ROOT = BENCHMARK.parents[1]
NOTES = BENCHMARK / "measured.toml"
WITH_CHANGES = "-and-changes"   # behind a commit: files were not as they are there
NO_HISTORY = 77
MOST_LINES = 5   # of commits, for each of the results


def git(*arguments, root=ROOT):
    return subprocess.run(["git", "-C", root, *arguments], check=True, capture_output=True,
                          text=True).stdout


def has_history(root=ROOT):
    """Whether all commits of the project are there, and not those of a project around it."""
    try:
        top, is_shallow = git("rev-parse", "--show-toplevel", "--is-shallow-repository",
                              root=root).splitlines()
    except (OSError, subprocess.CalledProcessError):
        return False
    return Path(top).resolve() == Path(root).resolve() and is_shallow == "false"


def load_notes(notes=NOTES):
    with open(notes, "rb") as stream:
        return tomllib.load(stream)


def paths_of(kind, kinds):
    return [*kinds[kind]["paths"],
            *(path for included in kinds[kind].get("includes", ())
              for path in paths_of(included, kinds))]


def short(commit):
    return commit[:7] + (WITH_CHANGES if commit.endswith(WITH_CHANGES) else "")


def measured_at(*names, notes=NOTES):
    """For documents: the commits of some results, as Markdown."""
    results = load_notes(notes)["results"]
    commits = {name: f"`{short(results[name]['commit'])}`" for name in names}
    if len(set(commits.values())) == 1:
        return f"Measured at commit {commits[names[0]]}."
    return "Measured at commits " + ", ".join(f"{commit} ({name.split('/')[1]})"
                                              for name, commit in commits.items()) + "."


def note(name, commit, notes=NOTES):
    text = notes.read_text(encoding="utf-8")
    text, found = re.subn(rf'^("{re.escape(name)}" = .*commit = ")[^"]*"',
                          lambda match: f'{match[1]}{commit}"', text, flags=re.MULTILINE)
    if found != 1:
        raise ValueError(f"{notes.name} has no results {name}")
    notes.write_text(text, encoding="utf-8")


def note_run(output):
    """Notes the commit that is checked out, if `output`, as of an option --output, names results
    that documents quote.

    Returns what the user has to be told, or None
    """
    folder = output.resolve().parent
    name = f"{folder.name}/{output.name}"
    notes = load_notes()
    if folder.parent != BENCHMARK or name not in notes["results"]:
        return None
    if not has_history():
        return (f"there is no history here: measured.py {name} COMMIT notes the commit in a "
                "repository that has it")
    paths = paths_of(notes["results"][name]["kind"], notes["kinds"])
    commit = git("rev-parse", "HEAD").strip()[:12]
    if git("status", "--porcelain", "--", *paths).strip():
        note(name, commit + WITH_CHANGES)
        return f"{name} was measured with changes that no commit has"
    note(name, commit)
    return None


def passed_over(trailer, commit, root):
    """The commits after `commit` that messages say to have moved nothing."""
    commits = set()
    log = git("log", "--format=%H%n%B%x00", f"{commit}..HEAD", root=root)
    for entry in log.split("\0"):
        if not entry.strip():
            continue
        one, *message = entry.strip().splitlines()
        for line in message:
            if line.strip() == trailer:
                commits.add(one)
            since = re.fullmatch(rf"{re.escape(trailer)} since ([0-9a-f]{{7,40}})", line.strip())
            if since:
                commits.update(git("rev-list", f"{since[1]}..{one}", root=root).split())
    return commits


def changes_since(commit, paths, trailer, root=ROOT):
    """The commits, the newest first, that have changed what was measured at `commit`."""
    log = git("log", "--full-history", "--no-merges", "--format=%H %s", f"{commit}..HEAD", "--",
              *paths, root=root).splitlines()
    same = passed_over(trailer, commit, root)
    return [line for line in log if line.split(" ", 1)[0] not in same]


def stale_results(notes=NOTES, root=ROOT):
    """Sentences."""
    loaded = load_notes(notes)
    for name, result in loaded["results"].items():
        commit, kind = result["commit"], result["kind"]
        if commit.endswith(WITH_CHANGES):
            yield f"{name} was measured with changes that no commit has"
            continue
        try:
            git("merge-base", "--is-ancestor", commit, "HEAD", root=root)
        except subprocess.CalledProcessError:
            yield f"{name} was measured at {commit}, which is no commit before this one"
            continue
        changes = changes_since(commit, paths_of(kind, loaded["kinds"]),
                                loaded["kinds"][kind]["trailer"], root)
        if changes:
            lines = "".join(f"\n    {line[:10]} {line.split(' ', 1)[1]}"
                            for line in changes[:MOST_LINES])
            more = f"\n    and {len(changes) - MOST_LINES} more" * (len(changes) > MOST_LINES)
            yield (f"{name} was measured at {short(commit)}, before these commits, of which none "
                   f"says '{loaded['kinds'][kind]['trailer']}':{lines}{more}")


def named_results(root=ROOT):
    """Of README and of each page of the manual, the results whose files it names."""
    for page in [root / "README.md", *sorted((root / "doc" / "L0_resampling").glob("*.txt"))]:
        found = re.findall(r"(\w+)/results/(\w+)\.(?:md|json)", page.read_text(encoding="utf-8"))
        yield page, {f"{folder}/{name}" for folder, name in found}


def results_without_commit(tables, root=ROOT):
    """Sentences: where a page names a result, and shows neither its commit nor its table, which has
    the commit too."""
    for page, names in named_results(root):
        text = page.read_text(encoding="utf-8")
        for name in sorted(names - tables):
            if not re.search(rf"\\measured_{name.replace('/', '_')}\b", text):
                yield f"{page.name} names {name} without the commit that it was measured at"


def tables_of_manual(root=ROOT):
    """The results whose tables the manual includes, and the text that says so."""
    path = root / "doc" / "L0_resampling" / "tools" / "generate_text.py"
    pages = path.read_text(encoding="utf-8")
    tables = re.search(r"^TABLES = (\{.*?\}\})$", pages, re.MULTILINE | re.DOTALL)
    return {f"{folder}/{name}" for folder, of_folder in eval(tables[1], {}).items()   # our own
            for name in of_folder}, pages


def quoted_results(root=ROOT):
    """The names of the results of which documents quote tables or figures, or name the files."""
    benchmark, manual = root / "benchmark" / "L0_resampling", root / "doc" / "L0_resampling"
    readme = (benchmark / "readme_figures.py").read_text(encoding="utf-8")
    plots = (manual / "make_plots.py").read_text(encoding="utf-8")
    tables, pages = tables_of_manual(root)
    names = {f"{folder}/{name}"
             for folder, name in re.findall(r'"(\w+)/results/(\w+)\.(?:md|json)"', readme)}
    names |= {f"{folder}/{name}" for folder, name in re.findall(r'tables_of\("(\w+)", "(\w+)"\)',
                                                               plots)}
    names |= tables.union(*(named for _, named in named_results(root)))
    names |= set(eval(re.search(r"^PLOTTED = (\(.*?\))$", pages, re.MULTILINE | re.DOTALL)[1], {}))
    names |= {f"{folder}/{name}" for folder, name in
              re.findall(r'"(\w+)" / "results" / "(\w+)\.(?:md|json)"', pages)}
    names |= {f"performance/{name}" for names in
              re.findall(r'"performance" / "results" / f"\{name\}\.json"\)\s+for name in \((.*?)\)',
                         pages, re.DOTALL) for name in re.findall(r'"(\w+)"', names)}
    return names


def main():
    if len(sys.argv) == 3:
        note(sys.argv[1], git("rev-parse", "--verify", f"{sys.argv[2]}^{{commit}}").strip()[:12])
        return
    if len(sys.argv) != 1:
        sys.exit(__doc__)
    noted = set(load_notes()["results"])
    errors = [f"documents quote {name}, of which measured.toml notes no commit"
              for name in sorted(quoted_results() - noted)]
    errors += [f"measured.toml has {name}, which no document quotes"
               for name in sorted(noted - quoted_results())]
    errors += results_without_commit(tables_of_manual()[0])
    if not has_history():
        print("The history of the project is not there, so figures were not compared with it.")
    else:
        errors += stale_results()
    for error in errors:
        print("measured:", error, file=sys.stderr)
    sys.exit(1 if errors else 0 if has_history() else NO_HISTORY)


if __name__ == "__main__":
    main()
