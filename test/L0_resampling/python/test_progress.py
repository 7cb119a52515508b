# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The progress bar, with and without tqdm."""

import importlib
import io
import sys
import types

import cgal_l0
import numpy
import pytest
from cgal_l0 import _progress


def test_a_bar_of_text(cube, monkeypatch):
    monkeypatch.setattr(_progress, "tqdm", None)
    file = io.StringIO()
    with cgal_l0.progress_bar("cube", file=file) as callback:
        with_bar = cgal_l0.l0_resample_point_set(cube, callback=callback)
    assert numpy.array_equal(with_bar[0], cgal_l0.l0_resample_point_set(cube)[0])
    shown = file.getvalue()
    assert shown.startswith("\rcube ") and shown.endswith("\n")
    percentages = [
        int(part.split("%")[0].split()[-1]) for part in shown.strip("\n").split("\r")[1:]
    ]
    assert percentages == sorted(set(percentages)) and len(percentages) > 3


def test_the_line_ends_after_an_error(cube, monkeypatch):
    monkeypatch.setattr(_progress, "tqdm", None)
    file = io.StringIO()
    with pytest.raises(LookupError), cgal_l0.progress_bar(file=file) as callback:
        callback(0.5)
        raise LookupError
    assert file.getvalue().endswith("\n") and " 50 % " in file.getvalue()


def test_nothing_in_a_log(cube, capsys):
    with cgal_l0.progress_bar() as callback:   # the standard error of a test is no terminal
        cgal_l0.l0_resample_point_set(cube, callback=callback)
    assert capsys.readouterr() == ("", "")


def test_with_tqdm(cube, monkeypatch):
    updates = []

    class Bar:
        n = 0.0

        def __init__(self, desc, total, file, bar_format):
            assert desc == "cube" and total == 100

        def __enter__(self):
            return self

        def __exit__(self, *_):
            updates.append("closed")

        def update(self, step):
            self.n += step
            updates.append(self.n)
            return True

    monkeypatch.setattr(_progress, "tqdm", Bar)
    with cgal_l0.progress_bar("cube", file=io.StringIO()) as callback:
        assert callback(0.25) is None   # which does not cancel
        callback(1)
    assert updates == [25, 100, "closed"]


def test_tqdm_is_found(monkeypatch):
    fake = types.ModuleType("tqdm.auto")
    fake.tqdm = object()
    monkeypatch.setitem(sys.modules, "tqdm", types.ModuleType("tqdm"))
    monkeypatch.setitem(sys.modules, "tqdm.auto", fake)
    try:
        assert importlib.reload(_progress).tqdm is fake.tqdm
    finally:
        monkeypatch.undo()
        importlib.reload(_progress)
