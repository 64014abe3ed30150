"""Matrices over Dask: a real scheduler, three worker processes of which one is killed, and the same values."""

import json
import os
import re
import signal
import subprocess
import sys
import time

import numpy as np
import pytest
import vorogeo
from vorogeo.cli.main import main

from sample_meshes import bent_grid, plane_grid, write_off

dask = pytest.importorskip("dask")
distributed = pytest.importorskip("distributed")
vorogeo_dask = pytest.importorskip("vorogeo.dask")

MESH = bent_grid(28, 25)


@pytest.fixture(scope="module")
def index():
    return vorogeo.GeodesicIndex(*MESH, patches=(4, 3))


@pytest.fixture(scope="module")
def cluster(tmp_path_factory):
    """The address of a scheduler with three workers, each a process of its own, and their process ids."""
    folder = tmp_path_factory.mktemp("cluster")
    log = folder / "scheduler.log"
    started = []

    def start(role, *options, output):
        command = [sys.executable, "-m", f"distributed.cli.dask_{role}", *options, "--no-dashboard"]
        with open(output, "w") as out:
            started.append(subprocess.Popen(command, stdout=out, stderr=out, cwd=folder))

    try:
        start("scheduler", "--host", "127.0.0.1", "--port", "0", output=log)
        address = None
        for _ in range(600):
            found = re.search(r"Scheduler at:\s+(tcp://\S+)", log.read_text())
            if found:
                address = found.group(1)
                break
            time.sleep(0.05)
        assert address, log.read_text()
        for k in range(3):
            start("worker", address, "--nthreads", "1", "--no-nanny", output=folder / f"worker{k}.log")
        with distributed.Client(address) as client:
            client.wait_for_workers(3, timeout=60)
        yield address, started[1:]
    finally:
        for process in started:
            process.kill()
            process.wait()


@pytest.mark.parametrize("dtype", ["float32", "float64"])
def test_blocks_of_rows_are_the_fields(index, dtype):
    lazy = vorogeo_dask.matrix(index, dtype, rows=100)
    assert lazy.shape == (700, 700)
    assert lazy.dtype == dtype
    assert lazy.chunks[0] == (100,) * 7
    expected = index.fields(np.arange(700), dtype=dtype)
    np.testing.assert_array_equal(lazy.compute(scheduler="threads"), expected)
    np.testing.assert_array_equal(lazy[130:135, ::3].compute(scheduler="threads"), expected[130:135, ::3])


def test_of_chosen_points_from_an_index_file_and_exactly(index, tmp_path):
    index.save(tmp_path / "m.vgi")
    points = [3, 99, 650, 4]
    lazy = vorogeo_dask.matrix(tmp_path / "m.vgi", points=points, mesh=MESH, method="exact", folder=tmp_path / "shared")
    expected = np.array([vorogeo.exact_distance_field(*MESH, point)[points] for point in points])
    np.testing.assert_allclose(lazy.compute(scheduler="sync"), expected, rtol=1e-12, atol=1e-15)
    with pytest.raises(vorogeo.InvalidInput, match="mesh: is missing"):
        vorogeo_dask.matrix(tmp_path / "m.vgi")
    with pytest.raises(vorogeo.IndexFileError):
        vorogeo_dask.matrix(tmp_path / "m.vgi", mesh=bent_grid(10, 10))


def test_entries_of_pairs_are_those_of_the_index(index):
    lazy = vorogeo_dask.matrix(index, points=[3, 99, 650], entries="pairs")
    expected = [[index.distance(a, b) for b in (3, 99, 650)] for a in (3, 99, 650)]
    np.testing.assert_array_equal(lazy.compute(scheduler="sync"), expected)
    with pytest.raises(vorogeo.InvalidInput, match="entries: "):
        vorogeo_dask.matrix(index, entries="rows")


def test_workers_measure_in_the_metric_of_the_index(index, tmp_path):
    metric = vorogeo.VertexCost(1 + MESH[0][:, 0] ** 2)
    painted = vorogeo.GeodesicIndex(*MESH, patches=(4, 3), metric=metric)
    expected = painted.fields(np.arange(700))
    np.testing.assert_array_equal(vorogeo_dask.matrix(painted).compute(scheduler="threads"), expected)
    painted.save(tmp_path / "m.vgi")
    lazy = vorogeo_dask.matrix(tmp_path / "m.vgi", mesh=MESH, metric=metric)
    np.testing.assert_array_equal(lazy[5].compute(scheduler="sync"), expected[5])
    with pytest.raises(vorogeo.IndexFileError):
        vorogeo_dask.matrix(tmp_path / "m.vgi", mesh=MESH)


def test_temporary_files_go_with_the_array(index, tmp_path, monkeypatch):
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    lazy = vorogeo_dask.matrix(index)
    assert len(list(tmp_path.iterdir())) == 1
    del lazy
    assert list(tmp_path.iterdir()) == []


def test_gaps_are_bridged_as_in_the_index_file(tmp_path):
    vertices, faces = plane_grid(9, 9)
    apart = np.vstack([vertices, vertices + np.array([1.01, 0, 0])]), np.vstack([faces, faces + 81])
    index = vorogeo.GeodesicIndex(*apart, patches=(2, 2), gap=0.02)
    index.save(tmp_path / "m.vgi")
    lazy = vorogeo_dask.matrix(tmp_path / "m.vgi", points=[0, 81 + 8], mesh=apart, gap=0.02)
    np.testing.assert_allclose(lazy.compute(scheduler="sync"), [[0, 2.01], [2.01, 0]], rtol=0.01)


def test_workers_map_one_index_file(cluster, index, tmp_path):
    files = vorogeo_dask.write_files(index, str(tmp_path))

    def mapped(files):
        return files.open().statistics.mapped_bytes

    with distributed.Client(cluster[0]) as client:
        found = client.run(mapped, files)
    assert len(found) >= 2
    tables = (tmp_path / "index.vgi").stat().st_size / 2
    assert all(size > tables for size in found.values())


def test_one_of_three_workers_is_killed_and_the_result_in_zarr_is_complete_and_equal(cluster, index, tmp_path):
    zarr = pytest.importorskip("zarr")
    address, workers = cluster
    lazy = vorogeo_dask.matrix(index, "float32", rows=10, folder=tmp_path / "shared")

    def slowly(block):  # a local function, which travels by value
        import time

        time.sleep(0.03)
        return block

    slow = lazy.map_blocks(slowly, dtype=lazy.dtype)
    with distributed.Client(address) as client:
        stored = client.compute(slow.to_zarr(str(tmp_path / "m.zarr"), compute=False))
        for _ in range(200):
            if list((tmp_path / "m.zarr").glob("**/c/*/*")):  # some blocks are written
                break
            time.sleep(0.02)
        assert not stored.done()
        os.kill(workers[0].pid, signal.SIGKILL)
        stored.result(timeout=120)
        assert len(client.scheduler_info(n_workers=-1)["workers"]) == 2
    np.testing.assert_array_equal(
        np.asarray(zarr.open(str(tmp_path / "m.zarr"), mode="r")[:]), index.fields(np.arange(700), dtype="float32")
    )


def test_the_command_line_uses_the_scheduler_for_one_matrix_and_for_many_meshes(
    cluster, index, tmp_path, monkeypatch, capsys
):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "shapes").mkdir()
    write_off(tmp_path / "shapes" / "m.off", *MESH)
    (tmp_path / "shapes" / "bad.off").write_text("OFF\n")
    index.save("m.vgi")
    address, _ = cluster
    whole = ["matrix", "shapes/m.off", "--index", "m.vgi", "--out", "m.npy", "--scheduler", address, "--json"]
    assert main(whole) == 0
    (told,) = json.loads(capsys.readouterr().out)["results"]
    assert (told["mesh"], told["out"], told["shape"]) == ("shapes/m.off", "m.npy", [700, 700])
    np.testing.assert_array_equal(np.load("m.npy"), index.fields(np.arange(700)))
    pairs = ["matrix", "shapes/m.off", "--index", "m.vgi", "--entries", "pairs", "--scheduler", address]
    assert main([*pairs, "--out", "m.npy", "--overwrite"]) == 0
    np.testing.assert_array_equal(np.load("m.npy"), index.distance_matrix(np.arange(700), entries="pairs"))
    np.savetxt("few.txt", [3, 80, 699], fmt="%d")
    assert main([*pairs, "--points", "few.txt", "--out", "few.npy"]) == 0
    np.testing.assert_array_equal(np.load("few.npy"), index.distance_matrix([3, 80, 699], entries="pairs"))
    os.remove("few.npy")
    os.remove("few.txt")
    capsys.readouterr()
    np.save("cost.npy", np.full(700, 3.0))
    np.savetxt("source.txt", [7])
    pair = ["distance", "shapes/m.off", "--from", "source.txt", "--to", "9", "--exact", "--scheduler", address]
    assert main(pair) == 0  # nothing is written, but printed
    assert float(capsys.readouterr().out) == pytest.approx(vorogeo.exact_distance_field(*MESH, 7)[9])
    np.save("regions.npy", np.zeros(700, int))
    assert main(["area", "shapes/m.off", "--regions", "regions.npy", "--scheduler", address]) == 0
    assert float(capsys.readouterr().out.split()[0]) == pytest.approx(index.area(vertices=np.zeros(700, int))[0].area)
    os.remove("regions.npy")
    of_folder = ["field", "shapes/*.off", "--from", "source.txt", "--exact", "--metric", "cost.npy", "--out", "out"]
    assert main([*of_folder, "--scheduler", address]) == 1
    np.testing.assert_allclose(np.load("out/m.npy"), 3 * vorogeo.exact_distance_field(*MESH, 7), rtol=1e-12)
    assert sorted(os.listdir()) == ["cost.npy", "m.npy", "m.vgi", "out", "shapes", "source.txt"]


def test_a_scheduler_that_is_not_there_is_one_line(tmp_path, capsys, monkeypatch):
    monkeypatch.setattr("vorogeo.cli.cluster._SECONDS", 1)
    write_off(tmp_path / "m.off", *MESH)
    arguments = [
        "matrix",
        str(tmp_path / "m.off"),
        "--out",
        str(tmp_path / "m.npy"),
        "--scheduler",
        "tcp://127.0.0.1:1",
    ]
    assert main(arguments) == 1
    error = capsys.readouterr().err.strip().splitlines()[-1]
    assert "--scheduler tcp://127.0.0.1:1: cannot be reached" in error
    assert [file.name for file in tmp_path.iterdir()] == ["m.off"]
