"""One index in several Python threads, and the GIL during long calls."""

import threading
import time
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import vorogeo

from sample_meshes import bent_grid

MESH = bent_grid(50, 40)


def test_index_outlives_its_last_name_while_threads_use_it():
    index = vorogeo.GeodesicIndex(*MESH)
    expected = index.distance_field(7)
    with ThreadPoolExecutor(4) as pool:
        waiting = [pool.submit(index.distance_field, 7) for _ in range(20)]
        del index
        for result in waiting:
            np.testing.assert_array_equal(result.result(), expected)


def ticks_during(call):
    """Moments in the middle half of the call at which another Python thread ran, and its duration."""
    ticks = []
    stop = threading.Event()

    def tick():
        while not stop.wait(0.001):
            ticks.append(time.perf_counter())

    thread = threading.Thread(target=tick)
    thread.start()
    try:
        begin = time.perf_counter()
        call()
        duration = time.perf_counter() - begin
    finally:
        stop.set()
        thread.join()
    return [t for t in ticks if begin + duration / 4 < t < begin + 3 * duration / 4], duration


def test_exact_field_releases_the_gil():
    vertices, faces = bent_grid(200, 200)
    ticks, duration = ticks_during(lambda: vorogeo.exact_distance_field(vertices, faces, 0))
    assert duration > 0.05
    assert len(ticks) >= 5


def test_build_releases_the_gil():
    vertices, faces = bent_grid(80, 80)
    ticks, duration = ticks_during(lambda: vorogeo.GeodesicIndex(vertices, faces))
    assert duration > 0.05
    assert len(ticks) >= 5


def test_build_inside_a_thread_reports_there():
    seen = set()
    with ThreadPoolExecutor(2) as pool:

        def build(seed):
            vorogeo.GeodesicIndex(*MESH, seed=seed, progress=lambda fraction, text: seen.add(threading.get_ident()))
            return threading.get_ident()

        workers = set(pool.map(build, range(4)))
    assert seen == workers
