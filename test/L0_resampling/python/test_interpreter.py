# Copyright (c) 2026  The CGAL::L0_resampling authors.
# All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later

"""A call of cgal_l0 lets the rest of Python live: progress, cancellation, Ctrl-C, other threads."""

import os
import signal
import threading
import time

import numpy
import pytest
from cgal_l0 import Cancelled, l0_resample_point_set


def test_progress_rises_in_the_calling_thread(endless):
    shares, threads = [], set()

    def callback(share):
        shares.append(share)
        threads.add(threading.get_ident())
        return len(shares) < 20   # None would go on too

    with pytest.raises(Cancelled):
        l0_resample_point_set(**endless, callback=callback)
    assert len(shares) == 20   # never asked again after it has said no
    assert all(0 <= a <= b <= 1 for a, b in zip(shares, shares[1:]))
    assert threads == {threading.get_ident()}


def test_a_callback_without_an_answer_goes_on(cube):
    with_callback = l0_resample_point_set(cube, callback=lambda share: None)
    assert numpy.array_equal(with_callback[0], l0_resample_point_set(cube)[0])


def test_the_exception_of_the_callback_passes(endless):
    def callback(share):
        raise LookupError("of the callback")

    with pytest.raises(LookupError, match="of the callback"):
        l0_resample_point_set(**endless, callback=callback)


@pytest.mark.parametrize("callback", [None, lambda share: True])
def test_ctrl_c(endless, callback):
    timer = threading.Timer(0.5, os.kill, (os.getpid(), signal.SIGINT))
    timer.start()
    with pytest.raises(KeyboardInterrupt):
        l0_resample_point_set(**endless, callback=callback)
    timer.join()


def test_other_threads_run_meanwhile(endless):
    ticks, stop = [], threading.Event()

    def tick():   # each needs the interpreter anew
        while not stop.is_set():
            time.sleep(0.001)
            ticks.append(None)

    thread = threading.Thread(target=tick)
    timer = threading.Timer(1, os.kill, (os.getpid(), signal.SIGINT))
    thread.start()
    timer.start()
    before = len(ticks)
    with pytest.raises(KeyboardInterrupt):
        l0_resample_point_set(**endless)
    during = len(ticks) - before
    stop.set()
    thread.join()
    assert during > 10


def test_calls_in_two_threads_do_not_meet(cube):
    alone = l0_resample_point_set(cube), l0_resample_point_set(cube, method="lor")
    together = [None, None]

    def call(k, method, threads):
        together[k] = l0_resample_point_set(cube, method=method, threads=threads)

    threads = [threading.Thread(target=call, args=(0, "default", 1)),
               threading.Thread(target=call, args=(1, "lor", 2))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    for one, other in zip(alone, together):
        assert numpy.array_equal(one[0], other[0]) and numpy.array_equal(one[1], other[1])
