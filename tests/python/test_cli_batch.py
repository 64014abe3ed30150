"""The command line on many meshes: what fails ends nothing else, what is done is kept, and no file is half."""

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest
import vorogeo
from vorogeo.cli import worker
from vorogeo.cli.job import Job
from vorogeo.cli.main import main

from sample_meshes import bent_grid, plane_grid, write_off

SHAPES = {"a": plane_grid(6, 5), "b": plane_grid(7, 4, 2.0), "c": bent_grid(6, 6)}


@pytest.fixture
def shapes(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "shapes").mkdir()
    for name, mesh in SHAPES.items():
        write_off(tmp_path / "shapes" / f"{name}.off", *mesh)
    return tmp_path / "shapes"


COMMAND = ["matrix", "shapes/*.off", "--out", "out/", "--dtype", "float32", "--normalise", "sqrt-area", "--jobs", "2"]


def expected_matrix(name):
    vertices, faces = SHAPES[name]
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    area = np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2
    return np.array([vorogeo.exact_distance_field(vertices, faces, v) for v in range(len(vertices))]) / np.sqrt(area)


def test_one_bad_mesh_is_reported_at_the_end_and_ends_nothing_else(shapes, capsys):
    (shapes / "bad.off").write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 9\n")
    assert main(COMMAND) == 1
    said = capsys.readouterr()
    assert said.out.splitlines()[-1] == "3 done, 0 kept, 1 failed"
    assert len(said.err.splitlines()) == 1
    assert "bad.off" in said.err
    assert "9" in said.err
    assert sorted(os.listdir("out")) == ["a.npy", "b.npy", "c.npy", "vorogeo.json"]
    for name in SHAPES:
        found = np.load(f"out/{name}.npy")
        assert found.dtype == np.float32
        np.testing.assert_allclose(found, expected_matrix(name), rtol=0.05, atol=1e-6)


def test_what_is_done_is_kept_and_what_changed_is_made_again(shapes, capsys):
    assert main([*COMMAND, "--quiet"]) == 0
    before = {name: os.stat(f"out/{name}.npy").st_mtime_ns for name in SHAPES}
    os.remove("out/b.npy")
    os.utime("shapes/c.off", (time.time() + 5, time.time() + 5))
    assert main(COMMAND) == 0
    assert capsys.readouterr().out.splitlines()[-1] == "2 done, 1 kept, 0 failed"
    assert os.stat("out/a.npy").st_mtime_ns == before["a"]
    assert os.stat("out/c.npy").st_mtime_ns != before["c"]


def test_results_of_other_options_are_not_mixed(shapes, capsys):
    assert main([*COMMAND, "--quiet"]) == 0
    assert json.loads(Path("out/vorogeo.json").read_text())["dtype"] == "float32"
    other = [word if word != "float32" else "float64" for word in COMMAND]
    assert main(other) == 1
    assert "holds results with dtype 'float32', not 'float64'" in capsys.readouterr().err
    assert main([*other, "--overwrite", "--quiet"]) == 0
    assert np.load("out/a.npy").dtype == np.float64


def test_a_folder_of_matrices_by_the_former_name_of_entries_is_continued(shapes, capsys):
    assert main([*COMMAND, "--quiet"]) == 0
    record = Path("out/vorogeo.json")
    options = json.loads(record.read_text())
    options["method"] = options.pop("entries")
    record.write_text(json.dumps(options))
    assert main(COMMAND) == 0
    assert "method" not in json.loads(record.read_text())
    assert main([*COMMAND, "--entries", "pairs"]) == 1
    assert "holds results with entries 'automatic', not 'pairs'" in capsys.readouterr().err


def test_a_folder_is_its_meshes_and_names_may_not_clash(shapes, capsys):
    assert main(["sample", "shapes", "--count", "4", "--out", "picked", "--format", "csv", "--quiet"]) == 0
    assert sorted(os.listdir("picked")) == ["a.csv", "b.csv", "c.csv", "vorogeo.json"]
    (shapes / "a.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
    assert main(["sample", "shapes", "--count", "4", "--out", "picked"]) == 1
    assert "would both go into picked/a.npy" in capsys.readouterr().err
    assert main(["sample", "none/*.off", "--count", "4", "--out", "x"]) == 1
    assert main(["sample", "shapes", "--count", "4"]) == 1
    assert "--out: is missing" in capsys.readouterr().err


def test_a_process_that_is_killed_is_a_failure_like_any_other(monkeypatch):
    monkeypatch.setattr(sys, "executable", "/bin/sh")
    real = subprocess.run

    def killed(command, **how):
        return real(["/bin/sh", "-c", "kill -9 $$"], **how)

    monkeypatch.setattr(worker.subprocess, "run", killed)
    succeeded, line = worker.run_in_own_process(Job("info", "a.off", ""))
    assert not succeeded
    assert "ended by signal 9" in line


def test_no_file_is_half_whenever_the_program_is_killed(tmp_path):
    write_off(tmp_path / "m.off", *bent_grid(30, 30))
    target = tmp_path / "m.npy"
    command = [sys.executable, "-m", "vorogeo", "matrix", str(tmp_path / "m.off"), "--out", str(target), "--exact"]
    running = subprocess.Popen(command, stdout=subprocess.DEVNULL)
    while running.poll() is None and not list(tmp_path.glob("*.part")):  # until the file is being filled
        time.sleep(0.005)
    running.send_signal(signal.SIGKILL)
    running.wait()
    assert not target.exists() or np.load(target).shape == (900, 900)
    assert main(["matrix", str(tmp_path / "m.off"), "--out", str(target), "--quiet"]) == 0
    assert sorted(file.name for file in tmp_path.iterdir()) == ["m.npy", "m.off"]
    assert (np.diag(np.load(target)) == 0).all()


def test_ctrl_c_ends_with_a_line_and_its_status(shapes, monkeypatch, capsys):
    def interrupted(jobs, at_once):
        raise KeyboardInterrupt
        yield

    monkeypatch.setattr("vorogeo.cli.batch.in_processes", interrupted)
    assert main(COMMAND) == 130
    assert capsys.readouterr().err == "vorogeo: interrupted\n"
