"""Progress reports, cancelling, and Ctrl-C during a build."""

import signal
import sys
import threading
import time

import numpy as np
import pytest
import vorogeo

from sample_meshes import bent_grid

MESH = bent_grid(40, 30)


def test_fractions_rise_to_one_on_the_calling_thread():
    calls = []
    threads = set()

    def progress(fraction, text):
        calls.append((fraction, text))
        threads.add(threading.get_ident())

    vorogeo.GeodesicIndex(*MESH, progress=progress)
    fractions = [fraction for fraction, _ in calls]
    assert len(calls) >= 2
    assert fractions == sorted(fractions)
    assert all(0 <= fraction <= 1 for fraction in fractions)
    assert fractions[-1] == 1.0
    assert all(isinstance(text, str) and text for _, text in calls)
    assert threads == {threading.get_ident()}


@pytest.mark.parametrize("answer", [True, None, 1, "go on", 0, 0.0, "", (), np.int8(0), np.bool_(True)])
def test_other_answers_go_on(answer):
    expected = vorogeo.GeodesicIndex(*MESH).distance_field(0)
    index = vorogeo.GeodesicIndex(*MESH, progress=lambda fraction, text: answer)
    np.testing.assert_array_equal(index.distance_field(0), expected)


def test_numpy_false_cancels():
    with pytest.raises(vorogeo.Cancelled):
        vorogeo.GeodesicIndex(*MESH, progress=lambda fraction, text: np.bool_(False))


def test_exception_of_the_function_is_raised_unchanged():
    error = KeyError("mine")

    def progress(fraction, text):
        raise error

    with pytest.raises(KeyError) as caught:
        vorogeo.GeodesicIndex(*MESH, progress=progress)
    assert caught.value is error


def test_function_with_another_signature():
    with pytest.raises(TypeError):
        vorogeo.GeodesicIndex(*MESH, progress=lambda fraction: None)


def test_ctrl_c_stops_a_build_without_a_function():
    mesh = bent_grid(300, 300)
    # A shell without job control starts commands in the background with the signal ignored.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    timer = threading.Timer(0.3, signal.raise_signal, [signal.SIGINT])
    begin = time.perf_counter()
    timer.start()
    try:
        with pytest.raises(KeyboardInterrupt):
            vorogeo.GeodesicIndex(*mesh)
    finally:
        timer.cancel()
        timer.join()
        signal.signal(signal.SIGINT, before)
    assert time.perf_counter() - begin < 20


def test_tqdm_bar(capsys):
    pytest.importorskip("tqdm")
    vorogeo.GeodesicIndex(*MESH, progress=True)
    assert "100%" in capsys.readouterr().err


def test_tqdm_missing(monkeypatch):
    monkeypatch.setitem(sys.modules, "tqdm", None)
    monkeypatch.setitem(sys.modules, "tqdm.auto", None)
    with pytest.raises(ImportError, match="pip install tqdm"):
        vorogeo.GeodesicIndex(*MESH, progress=True)
    vorogeo.GeodesicIndex(*MESH, progress=False)
