"""The benchmarks: questions, errors, and the tables from a run on a small mesh with VoroGeo alone."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import vorogeo

import sample_meshes

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "bench"))
pytest.importorskip("scipy")
pytest.importorskip("matplotlib")
import bench
import choosing
import gaps
import matrices
import measure
import meshes
import methods
import peers
import questions
import summary
import tables


def test_errors_of_known_distances():
    exact = np.array([0.0, 1.0, 2.0, 4.0, 5.0, np.inf])
    found = np.array([0.0, 1.01, 1.99, 4.0, np.nan, 7.0])
    errors = summary.errors(found, exact)
    assert errors is not None
    assert errors["mean"] == pytest.approx((1 + 0.5 + 0) / 3)
    assert errors["over"] == pytest.approx(1)
    assert errors["under"] == pytest.approx(0.5)
    assert errors["missing"] == pytest.approx(25)


def test_spread_of_known_times():
    found = summary.spread([4.0, 1.0, 2.0, 3.0, 5.0])
    assert found is not None
    assert [found[key] for key in ("median", "q1", "q3", "min", "max", "count")] == [3, 2, 4, 1, 5, 5]


@pytest.mark.parametrize(
    ("seconds", "text"), [(12.34, "12.3 s"), (0.0456, "45.6 ms"), (7e-6, "7.00 µs"), (None, "-"), (1234.5, "1,234 s")]
)
def test_durations_have_the_unit_that_suits_them(seconds: float | None, text: str):
    assert tables.duration(seconds) == text


def test_text_between_marks_is_replaced(tmp_path: Path):
    page = tmp_path / "page.md"
    page.write_text("a\n<!-- table -->\nold\n<!-- end of table -->\nb\n")
    bench.replace(page, "table", "new\\1\n")
    assert page.read_text() == "a\n<!-- table -->\nnew\\1\n<!-- end of table -->\nb\n"
    with pytest.raises(SystemExit, match="no marks"):
        bench.replace(page, "other", "")


def test_pairs_are_near_in_patches_that_touch():
    mesh = sample_meshes.plane_grid(5, 2)  # four squares in a row, each a patch
    near = questions.Neighbourhood(mesh, np.tile(np.arange(4, dtype=np.int32), 2))
    far = near.far_pairs(np.array([0, 0, 0, 0]), np.array([1, 2, 3, 4]))
    # Vertex 0 is in square 0, which touches square 1, whose vertices are in squares 0 to 2.
    assert far.tolist() == [[0, 3], [0, 4]]
    pairs = near.near_pairs(np.zeros(100, np.int64), np.random.default_rng(0))
    assert set(pairs[:, 1].tolist()) <= {1, 2, 5, 6, 7}


def test_a_crash_and_a_limit_of_time_are_reported():
    status, errors, _ = measure.stream([sys.executable, "-c", "import os; os.abort()"], 20, print)
    assert (status, errors) == (-6, "")
    status, _, _ = measure.stream([sys.executable, "-c", "while True: pass"], 1, print)
    assert status == "limit"


def test_a_run_without_peers_gives_all_tables(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    mesh = sample_meshes.bent_grid(40, 30)
    monkeypatch.setattr(meshes, "WORK", tmp_path)
    monkeypatch.setattr(meshes, "load", lambda _: mesh)
    monkeypatch.setattr(measure, "core", lambda *arguments: made_up_core(arguments, mesh))
    chosen = peers.names(None, peers=False)
    assert chosen == [name for name in methods.METHODS if name.startswith("vorogeo")]
    result = peers.measure_mesh(tmp_path / "grid.ply", 2, chosen, measure.Limits(0.1, 60, 1), threads=2)
    own, exact = result["methods"]["vorogeo_index"], result["methods"]["vorogeo_exact"]
    assert not own["failure"]
    assert not exact["failure"]
    assert own["field_sources"] == exact["field_sources"] == 2
    assert 0 < own["field_error"]["mean"] < 0.1
    assert own["near_error"]["mean"] < 1e-9
    assert exact["field_error"]["mean"] == 0
    assert own["peak_bytes"] > 2**20
    details = " ".join(tables.details(result).split())
    assert re.search(r"a build takes 1\.00 s on 1 thread.*, and a field 3\.00 ms", details)
    for text in (tables.fields(result), tables.pairs(result)):
        for part in text.strip().split("\n\n"):
            lines = part.splitlines()
            assert len(lines) > 2
            assert len({line.count("|") for line in lines}) == 1
    assert "VoroGeo, exact" in tables.fields(result)
    assert len(tables.costs_row(result)) == len(tables.COSTS.split("|"))


def made_up_core(arguments: tuple[Any, ...], mesh: sample_meshes.Mesh) -> tuple[measure.Lines, int]:
    """What the C++ program would print, which is not built here; the index is a real one."""
    n = len(mesh[0])
    lines: dict[str, Any] = {
        "exact": {("exact", n): [0.1, 0.2]},
        "build": {("build", int(arguments[2]) if arguments[0] == "build" else 0): [1.0]},
        "fields": {("load", 1): [0.1], ("field", 1): [0.003], ("field", 2): [0.002]},
        "pairs": {("pair", 1): [1e-5]},
    }
    if arguments[0] == "build":
        vorogeo.GeodesicIndex(*mesh, patches=(4, 3)).save(arguments[3])
        lines["build"] |= {("index_bytes", n): [1000.0 * n], ("file_bytes", n): [500.0 * n]}
    return {key: measure.Line(values, values) for key, values in lines[arguments[0]].items()}, 2**27


def test_totals_of_each_choice():
    result = {"exact": 1.0, "build": 9.5, "index": 0.1, "quick": 0.01, "automatic": [1.0] * 9 + [9.6, 0.1, 0.1]}
    found = choosing.totals(result)
    assert found["exact"][[0, 999]] == pytest.approx([1, 1000])
    assert found["index"][[0, 999]] == pytest.approx([9.6, 109.5])
    assert found["automatic"][[0, 8, 9, 999]] == pytest.approx([1, 9, 18.6, 18.6 + 99])
    assert choosing.worst_ratio(result) == pytest.approx(1.86)  # after ten fields: 18.6 s instead of 10


def test_automatic_choice_is_measured():
    result = choosing.measured("grid", sample_meshes.bent_grid(12, 12))
    assert result["vertices"] == 144
    assert 0 < result["rented"] <= choosing.FIELDS
    assert result["exact"] > 0
    assert result["build"] > 0


def test_rows_of_a_matrix_stand_beside_those_of_exact_fields(tmp_path: Path, monkeypatch: pytest.MonkeyPatch):
    mesh = sample_meshes.bent_grid(20, 20)
    monkeypatch.setattr(matrices, "PEERS", ("vorogeo_exact", "no_such_package"))
    monkeypatch.setitem(methods.METHODS, "no_such_package", methods.Description("none", "no_such_package"))
    monkeypatch.setattr(meshes, "find", lambda _: tmp_path / "grid.ply")
    monkeypatch.setattr(meshes, "load", lambda _: mesh)
    for whole in (False, True):
        own, exact = matrices.rows_of("grid", 0.2, whole)
        assert own[0] == "grid, VoroGeo, index, float32"
        assert not whole or own[3] == "400"
        assert float(own[-1]) < 0.1
        assert exact[-1] == "0"


def test_our_methods_are_measured_like_others():
    mesh = sample_meshes.bent_grid(10, 10)
    exact = vorogeo.exact_distance_field(*mesh, 7)
    np.testing.assert_allclose(methods.make("our_mmp", *mesh, 1, None).field(7), exact)
    errors = summary.errors(methods.make("our_svg(K=20)", *mesh, 1, None).field(7), exact)
    assert errors is not None
    assert errors["mean"] < 5


def test_cracks_are_bridged_again():
    mesh = sample_meshes.bent_grid(30, 30)
    cut = gaps.with_cracks(mesh, 1e-3)
    assert vorogeo.check_mesh(*cut).components == 4
    assert [row[-1] for row in gaps.bridging(mesh)] == ["1, 1", "4, 1", f"{len(mesh[1]):,}, 1"]
