"""The command line for programs: JSON against the plane, completion as a shell asks for it, and what doctor finds."""

import json
import re
import shutil
import subprocess
import sys

import numpy as np
import pytest
import vorogeo
from vorogeo.cli.main import main
from vorogeo.cli.options import commands

from sample_meshes import plane_grid, prism, side_by_side, write_off

VERTICES, FACES = plane_grid(13, 11, 1.2, 1.0)
APART = np.linalg.norm(VERTICES[:, None] - VERTICES[None], axis=2)


@pytest.fixture
def asked(tmp_path, monkeypatch, capsys):
    """Asks a question of plane.off (or another mesh) with --json: status and the one object on the standard output."""
    monkeypatch.chdir(tmp_path)
    write_off(tmp_path / "plane.off", VERTICES, FACES)

    def ask(command, *options, mesh="plane.off"):
        status = main([command, mesh, *options, "--json"])
        said = capsys.readouterr()
        assert said.out.count("\n") == 1
        assert bool(said.err) == bool(status)
        found = json.loads(said.out)
        assert list(found) == ["command", "results", "failed", "kept"]
        assert found["command"] == command
        return status, found

    return ask


def test_every_command_tells_its_numbers(asked, tmp_path):
    def one(command, *options, **mesh):
        status, found = asked(command, *options, **mesh)
        assert (status, found["failed"], found["kept"]) == (0, [], 0)
        (result,) = found["results"]
        assert result["seconds"] >= 0
        return result

    diagonal = np.hypot(1.2, 1)
    field = one("field", "--from", "0", "--exact", "--out", "f.npy", "--quiet")
    assert (field["mesh"], field["out"]) == ("plane.off", "f.npy")
    assert (field["vertices"], field["reached"]) == (143, 143)
    assert field["farthest"] == pytest.approx(diagonal)
    distance = one("distance", "--from", "0", "--to", "12", "142", "--exact")
    assert distance["out"] is None
    assert distance["distance"] == pytest.approx([1.2, diagonal])
    path = one("path", "--from", "0", "--to", "142", "--exact")
    assert (path["length"], path["certified"]) == ([pytest.approx(diagonal)], [True])
    matrix = one("matrix", "--dtype", "float32", "--out", "m.npy")
    assert (matrix["shape"], matrix["bytes"]) == ([143, 143], 4 * 143 * 143)
    near = one("neighbours", "--radius", "0.25", "--exact", "--out", "n.npz")
    assert near["entries"] == ((APART <= 0.25) & (APART > 0)).sum()
    assert sum(one("voronoi", "--from", "0", "142", "--exact", "--out", "v.npz")["area"]) == pytest.approx(1.2)
    sample = one("sample", "--count", "7", "--out", "s.npy")
    assert sample["vertex"] == np.load("s.npy").tolist()
    assert sample["covering_radius"] == pytest.approx(APART[sample["vertex"]].min(axis=0).max(), rel=0.01)
    assert one("sample", "--method", "poisson", "--radius", "0.3", "--out", "s.npy")["covering_radius"] is None
    assert one("through", "--points", "0", "12", "142")["length"] == pytest.approx([2.2])
    circle = one("area", "--from", "0.6,0.5,0", "--radius", "0.3")
    assert [circle["area"], circle["border_length"]] == pytest.approx([np.pi * 0.09, np.pi * 0.6], rel=1e-3)
    square = one("polygon", "--points", "0.1,0.1,0", "0.8,0.1,0", "0.8,0.8,0", "0.1,0.8,0")
    assert [square["area"], square["perimeter"]] == pytest.approx([0.49, 2.8])
    assert one("profile", "--points", "0", "12", "--out", "p.csv")["length"] == pytest.approx(1.2)
    assert one("cut", "--points", "0.55,0,0", "0.55,1,0", "--out", "c.ply")["area"] == pytest.approx([0.55, 0.65])
    seen = one("directions", "--at", "0", "--out", "d.npy")
    assert (seen["vertices"], seen["reached"], seen["farthest"]) == (143, 143, pytest.approx(diagonal))
    sides = one("signed", "--curve", "14", "24", "128", "118", "--out", "s.npy")
    assert (sides["reached"], sides["inside"], sides["outside"]) == pytest.approx(
        (143, 0.4, np.hypot(0.1, 0.1)), abs=1e-6
    )
    assert one("spline", "--points", "0", "6", "12")["length"] == pytest.approx([1.2])
    assert one("mean", "--points", "0", "12", "142", "130")["point"] == pytest.approx([0.6, 0.5, 0.0])
    parts = one("clusters", "--count", "4", "--out", "k.npy", "--exact")
    assert (sum(parts["size"]), len(parts["centre"])) == (143, 4)
    assert one("cut-locus", "--from", "0", "11", "--out", "l.ply")["length"] == pytest.approx(1.0)
    index = one("index", "--out", "plane.vgi", "--patches", "3", "2")["index"]
    assert (index["vertices"], index["first_layer_patches"]) == (143, 3)
    info = one("info")
    assert (info["faces"], info["area"], info["size"]) == (240, pytest.approx(1.2), pytest.approx([1.2, 1.0, 0.0]))
    write_off(tmp_path / "tube.off", *prism(12, 9, 4.0))
    around = pytest.approx(24 * np.sin(np.pi / 12))
    girth = one("girth", "--at", "50", "--normal", "0,0,1", mesh="tube.off")
    assert [girth[name] for name in ("section", "tape", "loop")] == [around] * 3
    assert one("loop", "--at", "50", mesh="tube.off")["length"] == [around]


def test_compare_tells_what_its_table_shows(asked):
    np.save("twice.npy", 1.01 * APART[0])
    _, found = asked("compare", "--from", "0", "--with", "twice.npy")
    (row,) = found["results"][0]["methods"]
    assert [row[name] for name in ("mean", "p99", "largest")] == pytest.approx([1, 1, 1])
    assert (row["missed"], row["field_seconds"]) == (0, None)
    _, found = asked("compare", "--from", "0", "--methods", "mmp", "heat", "dijkstra")
    rows = {row["method"]: row for row in found["results"][0]["methods"]}
    assert list(rows) == ["mmp", "heat", "dijkstra"]
    assert rows["mmp"]["largest"] <= 1e-9
    assert rows["dijkstra"]["mean"] > rows["mmp"]["mean"]  # paths along edges
    assert min(row["field_seconds"] for row in rows.values()) > 0


def test_failures_and_unreachable_points_are_told(asked, tmp_path):
    status, found = asked("distance", "--from", "0", "--to", "999")
    assert (status, found["results"]) == (1, [])
    assert found["failed"][0]["mesh"] == "plane.off"
    assert "there is no vertex 999" in found["failed"][0]["error"]
    write_off(tmp_path / "two.off", *side_by_side((VERTICES, FACES), (VERTICES, FACES)))
    assert asked("distance", "--from", "0", "--to", "143", mesh="two.off")[1]["results"][0]["distance"] == [None]


def test_meshes_of_a_folder_are_one_object(asked, tmp_path):
    (tmp_path / "shapes").mkdir()
    write_off(tmp_path / "shapes" / "a.off", VERTICES, FACES)
    (tmp_path / "shapes" / "b.off").write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 9\n")
    status, found = asked("field", "--from", "0", "--out", "out/", "--exact", mesh="shapes")
    assert (status, found["kept"]) == (1, 0)
    assert [one["farthest"] for one in found["results"]] == pytest.approx([APART[0].max()])
    assert [one["mesh"].replace("\\", "/") for one in found["failed"]] == ["shapes/b.off"]
    assert asked("field", "--from", "0", "--out", "out/", "--exact", mesh="shapes/a.off")[1]["kept"] == 1


def test_bash_completes_commands_options_and_their_words(tmp_path):
    bash = shutil.which("bash")
    if bash is None:
        pytest.skip("there is no bash")
    assert subprocess.run([sys.executable, "-m", "vorogeo", "completion", "tcsh"], capture_output=True).returncode == 2
    script = printed("completion", "bash")

    def offered(*words):
        line = " ".join(f"'{word}'" for word in ("vorogeo", *words))
        ask = f"COMP_WORDS=({line}); COMP_CWORD={len(words)}; _vorogeo; echo ${{COMPREPLY[@]}}"
        return subprocess.run([bash, "-c", script + ask], capture_output=True, text=True, check=True).stdout.split()

    assert offered("fi") == ["field"]
    assert set(commands()) < set(offered(""))
    assert offered("matrix", "--entries", "") == ["automatic", "pairs", "fields"]
    assert offered("matrix", "--m") == ["--mask", "--max-snap", "--metric", "--memory-budget"]
    assert offered("sample", "a.ply", "--method", "p") == ["poisson"]
    assert offered("compare", "a.ply", "--methods", "h") == ["heat"]
    assert offered("field", "a.ply", "--max") == ["--max-snap", "--max-distance"]
    assert offered("completion", "z") == ["zsh"]
    assert offered("field", "a.pl") == []  # files are for the shell


def printed(*arguments):
    command = [sys.executable, "-m", "vorogeo", *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=True).stdout


@pytest.mark.parametrize("shell", ["bash", "zsh", "fish"])
def test_scripts_are_those_of_their_shell(tmp_path, shell):
    if shutil.which(shell) is None:
        pytest.skip(f"there is no {shell}")
    file = tmp_path / "vorogeo"
    file.write_text(printed("completion", shell))
    assert subprocess.run([shell, "-n", file], capture_output=True, text=True).stderr == ""
    if shell == "fish":
        ask = f"source {file}; complete -C 'vorogeo fi'"
        assert subprocess.run([shell, "-c", ask], capture_output=True, text=True).stdout.split()[0] == "field"


def test_doctor_says_what_is_there_and_why_filters_are_not(capsys, monkeypatch):
    assert main(["doctor"]) == 0
    said = capsys.readouterr().out
    assert f"vorogeo {vorogeo.__version__} in" in said
    assert f"numpy {np.__version__}" in said
    assert re.search(r"cores: \d+, (AVX-512|AVX2|SSE2|NEON) in use", said)

    def refuse():
        raise vorogeo.PluginError("PyMeshLab is not installed")

    monkeypatch.setattr("vorogeo.cli.doctor.load_plugin", refuse)
    assert main(["doctor", "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["command"] == "doctor"
    assert found["plugin"] == {"filters": 0, "file": None, "why": "PyMeshLab is not installed"}
    assert main(["doctor"]) == 0
    assert "no filters: PyMeshLab is not installed" in capsys.readouterr().out
