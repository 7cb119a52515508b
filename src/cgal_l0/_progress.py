# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""The progress of a call, for people."""

import contextlib
import sys

try:
    from tqdm.auto import tqdm
except ImportError:
    tqdm = None

_width = 30   # of the bar, in characters


def _is_shown(file):
    """On terminals and in notebooks; elsewhere, as in a log, a bar would be many lines."""
    return file.isatty() or "ipykernel" in sys.modules


@contextlib.contextmanager
def progress_bar(description="resampling", *, file=None):
    """Show a progress bar, in terminals and notebooks.

    with cgal_l0.progress_bar() as callback:
        positions, normals = cgal_l0.l0_resample_point_set(points, callback=callback)

    description: str that stands before the bar. Default: "resampling".
    file: where the bar is written. Default: sys.stderr, if it is a terminal or a notebook; else
        there is no bar.

    Where the package tqdm is installed, the bar is one of tqdm, in notebooks a widget. The value
    of the with statement is a callback for l0_resample_point_set(), read_points() or a function
    of your own: it takes the progress, a float in [0, 1].
    """
    if file is None and not _is_shown(sys.stderr):
        yield lambda share: None
    elif tqdm is not None:
        with tqdm(
            desc=description,
            total=100,
            file=file,
            bar_format="{desc} {percentage:3.0f} % |{bar}| {elapsed}",
        ) as bar:
            yield lambda share: bar.update(100 * share - bar.n) and None
    else:
        yield from _text_bar(description, sys.stderr if file is None else file)


def _text_bar(description, file):
    shown = None

    def callback(share):
        nonlocal shown
        percentage = int(100 * share)
        if percentage != shown:
            shown = percentage
            bar = ("#" * (_width * percentage // 100)).ljust(_width)
            file.write(f"\r{description} {percentage:3} % |{bar}|")
            file.flush()

    try:
        yield callback
    finally:
        if shown is not None:
            file.write("\n")
            file.flush()
