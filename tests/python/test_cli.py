"""The command line on one mesh: values against the plane and the package, formats, printed lines, errors and status."""

import re
import subprocess
import sys
from pathlib import Path

import meshio
import numpy as np
import pytest
import vorogeo
from vorogeo.cli.main import main

from sample_meshes import plane_grid, prism, write_off

VERTICES, FACES = plane_grid(13, 11, 1.2, 1.0)
APART = np.linalg.norm(VERTICES[:, None] - VERTICES[None], axis=2)
ENDINGS = ("npy", "npz", "mat", "csv", "ply", "gii")
NEAR = {"rtol": 0.01, "atol": 1e-6}


@pytest.fixture
def mesh(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    write_off(tmp_path / "plane.off", VERTICES, FACES)
    return "plane.off"


def test_field_in_every_format(mesh, tmp_path):
    import nibabel
    from scipy.io import loadmat

    for ending in ENDINGS:
        assert main(["field", mesh, "--from", "0", "140", "--out", f"f.{ending}", "--quiet", "--exact"]) == 0
    expected = APART[[0, 140]].min(axis=0)
    np.testing.assert_allclose(np.load("f.npy"), expected, atol=1e-12)
    np.testing.assert_array_equal(np.load("f.npz")["distance"], np.load("f.npy"))
    np.testing.assert_array_equal(loadmat("f.mat")["distance"].ravel(), np.load("f.npy"))
    np.testing.assert_array_equal(np.loadtxt("f.csv", skiprows=1), np.load("f.npy"))
    ply = meshio.read("f.ply")
    np.testing.assert_array_equal(ply.points, VERTICES)
    np.testing.assert_array_equal(ply.cells[0].data, FACES)
    np.testing.assert_allclose(ply.point_data["quality"], expected, atol=1e-6)
    np.testing.assert_allclose(nibabel.load("f.gii").darrays[0].data, expected, atol=1e-6)
    assert {file.name for file in tmp_path.iterdir()} == {mesh, *(f"f.{e}" for e in ENDINGS)}


def test_sources_are_ids_positions_and_files(mesh, tmp_path):
    np.save("ids.npy", [0, 12])
    (tmp_path / "points.csv").write_text("0.0, 0.52, 0.3\n1.2, 0.31, 0.0\n")
    assert main(["field", mesh, "--from", "ids.npy", "points.csv", "0.55,0.6,9", "--out", "f.npy", "--exact"]) == 0
    sources = np.array([[0, 0], [1.2, 0], [0, 0.52], [1.2, 0.31], [0.55, 0.6]])
    expected = np.linalg.norm(VERTICES[:, None, :2] - sources[None], axis=2).min(axis=1)
    np.testing.assert_allclose(np.load("f.npy"), expected, atol=1e-9)


def test_positions_below_0_are_no_options(mesh, capsys):
    assert main(["distance", mesh, "--from", "0", "--to", "-0.1,0.5,0", "-1e-3,-.2,-3"]) == 0
    np.testing.assert_allclose([float(line) for line in capsys.readouterr().out.split()], [0.5, 0], atol=1e-9)
    assert main(["girth", mesh, "--at", "-1,0,0", "--normal", "-1,0,0"]) == 1
    assert "is not closed" in capsys.readouterr().err


def test_one_answer_builds_no_index(mesh, capsys, monkeypatch):
    def refuse(*_, **__):
        raise AssertionError("an index is built")

    monkeypatch.setattr("vorogeo.cli.job.GeodesicIndex", refuse)
    for command in ("distance", "path"):
        assert main([command, mesh, "--from", "0", "--to", "142"]) == 0
        assert float(capsys.readouterr().out) == pytest.approx(np.hypot(1.2, 1), rel=1e-9)
    assert main(["field", mesh, "--from", "0", "--out", "f.npy", "--patches", "2", "2"]) == 1
    assert "an index is built" in capsys.readouterr().err


def test_distance_and_path_print_or_write(mesh, capsys):
    assert main(["distance", mesh, "--from", "0", "--to", "12", "142", "1.0,0.5,0"]) == 0
    printed = [float(line) for line in capsys.readouterr().out.split()]
    np.testing.assert_allclose(printed, [1.2, np.hypot(1.2, 1), np.hypot(1, 0.5)], rtol=0.01)
    assert main(["path", mesh, "--from", "0", "--to", "142", "--exact"]) == 0
    assert float(capsys.readouterr().out) == pytest.approx(np.hypot(1.2, 1), rel=1e-9)
    for ending in ("npz", "csv", "ply"):
        assert main(["path", mesh, "--from", "0", "1", "--to", "142", "--out", f"p.{ending}", "--quiet"]) == 0
    paths = np.load("p.npz")
    for k in range(2):
        points = paths["points"][paths["path"] == k]
        assert np.linalg.norm(np.diff(points, axis=0), axis=1).sum() == pytest.approx(paths["length"][k])
    surface = vorogeo.SurfacePoints(paths["face"], paths["barycentric"])
    np.testing.assert_allclose(surface.positions(VERTICES, FACES), paths["points"], atol=1e-12)
    table = np.loadtxt("p.csv", delimiter=",", skiprows=1)
    np.testing.assert_array_equal(table[:, 1:4], paths["points"])
    assert b"element edge" in Path("p.ply").read_bytes()[:400]


def test_matrix_of_all_and_of_chosen_points(mesh):
    assert main(["matrix", mesh, "--out", "m.npy", "--dtype", "float32", "--quiet"]) == 0
    whole = np.load("m.npy")
    assert whole.dtype == np.float32
    np.testing.assert_allclose(whole, APART, **NEAR)
    assert main(["matrix", mesh, "--points", "3", "77", "--to", "5", "--out", "m.npz", "--exact", "--quiet"]) == 0
    np.testing.assert_allclose(np.load("m.npz")["matrix"], APART[[3, 77]][:, [5]])
    assert main(["matrix", mesh, "--points", "3", "77", "--out", "m.csv", "--quiet"]) == 0
    assert np.loadtxt("m.csv", delimiter=",").shape == (2, 2)


def test_entries_of_a_matrix_also_by_the_former_name_of_the_option(mesh, capsys):
    assert main(["index", mesh, "--patches", "3", "3", "--out", "i.vgi", "--quiet"]) == 0
    index = vorogeo.GeodesicIndex.load("i.vgi", VERTICES, FACES)
    ids = np.arange(len(VERTICES))
    for entries in ("pairs", "fields"):
        for option in ("--entries", "--method"):
            assert main(["matrix", mesh, "--index", "i.vgi", option, entries, "--out", "m.npy", "--quiet"]) == 0
            np.testing.assert_array_equal(np.load("m.npy"), index.distance_matrix(ids, entries=entries))
    capsys.readouterr()
    assert main(["matrix", "--help"]) == 0
    shown = capsys.readouterr().out
    assert "--entries {automatic,pairs,fields}" in shown
    assert "--method" not in shown


def test_normalised_lengths_are_parts_of_the_root_of_the_area(mesh):
    assert main(["matrix", mesh, "--out", "m.npy", "--normalise", "sqrt-area", "--exact", "--quiet"]) == 0
    np.testing.assert_allclose(np.load("m.npy"), APART / np.sqrt(1.2), atol=1e-12)
    assert main(["field", mesh, "--from", "0.3,0.4,0", "--normalise", "sqrt-area", "--out", "f.npy", "--exact"]) == 0
    expected = np.hypot(VERTICES[:, 0] - 0.3, VERTICES[:, 1] - 0.4) / np.sqrt(1.2)
    np.testing.assert_allclose(np.load("f.npy"), expected, atol=1e-9)


def test_neighbours_are_sparse(mesh):
    from scipy.sparse import load_npz

    assert main(["neighbours", mesh, "--radius", "0.25", "--exact", "--out", "n.npz", "--quiet"]) == 0
    found = load_npz("n.npz").tocoo()
    assert set(zip(found.row, found.col, strict=True)) == set(map(tuple, np.argwhere((APART <= 0.25) & (APART > 0))))
    np.testing.assert_allclose(found.data, APART[found.row, found.col])
    assert main(["neighbours", mesh, "--radius", "0.25", "--exact", "--out", "n.csv", "--quiet"]) == 0
    assert len(np.loadtxt("n.csv", delimiter=",", skiprows=1)) == found.nnz


def test_voronoi_sample_index_compare_and_info(mesh, capsys):
    assert main(["voronoi", mesh, "--from", "0", "142", "--exact", "--out", "v.npz", "--quiet"]) == 0
    regions = np.load("v.npz")
    assert regions["area"].sum() == pytest.approx(1.2)
    clear = np.abs(APART[0] - APART[142]) > 1e-9
    np.testing.assert_array_equal(regions["vertex_region"][clear], (APART[142] < APART[0])[clear])
    assert main(["sample", mesh, "--count", "7", "--out", "s.npy", "--quiet"]) == 0
    assert len(set(np.load("s.npy").tolist())) == 7
    assert main(["sample", mesh, "--method", "poisson", "--radius", "0.3", "--out", "s.npy", "--quiet"]) == 0
    ids = np.load("s.npy")
    assert (APART[np.ix_(ids, ids)] + np.eye(len(ids)) >= 0.3 * 0.99).all()
    assert main(["index", mesh, "--out", "plane.vgi", "--patches", "3", "2", "--quiet"]) == 0
    assert main(["field", mesh, "--from", "0", "--index", "plane.vgi", "--out", "f.npy"]) == 0
    assert "reached" in capsys.readouterr().out
    np.testing.assert_allclose(np.load("f.npy"), APART[0], **NEAR)
    np.save("twice.npy", 1.01 * APART[0])
    assert main(["compare", mesh, "--from", "0", "--with", "twice.npy"]) == 0
    assert "mean error 1 %" in capsys.readouterr().out
    assert main(["compare", mesh, "--from", "0", "--methods", "dijkstra", "--out", "d.npy", "--quiet"]) == 0
    small, large = np.sort(np.abs(VERTICES[:, :2] - VERTICES[0, :2]), axis=1).T
    assert np.load("d.npy").min() >= -1e-9
    assert np.load("d.npy").max() <= (large + small - np.hypot(large, small)).max() + 1e-9
    assert main(["info", mesh]) == 0
    assert "143 vertices" in capsys.readouterr().out


def test_compare_shows_all_methods_in_one_table(mesh, capsys):
    assert main(["compare", mesh, "--from", "0", "--methods", "all", "--patches", "3", "2", "--out", "c.npz"]) == 0
    found = np.load("c.npz")
    assert found["method"].tolist() == ["index", *list(vorogeo.methods)[1:]]
    np.testing.assert_allclose(found["exact"], APART[0], atol=1e-12)
    for name, error in zip(found["method"].tolist(), found["error"], strict=True):
        assert np.abs(error).max() <= (1e-9 if name in ("mmp", "ch", "ich") else 0.5), name
    capsys.readouterr()
    assert main(["compare", mesh, "--from", "0", "142", "--methods", "mmp", "gsp"]) == 0
    head, *rows = capsys.readouterr().out.splitlines()[1:]
    assert head.split()[0] == "method"
    assert [row.split()[0] for row in rows] == ["mmp", "gsp"]
    assert float(rows[0].split()[3]) <= 1e-9
    # More components than GTU takes samples.
    corners = np.arange(120)[:, None, None] * [2, 0, 0] + [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    meshio.Mesh(corners.reshape(-1, 3), [("triangle", np.arange(360).reshape(-1, 3))]).write("loose.ply")
    assert main(["compare", "loose.ply", "--from", "0", "--methods", "all"]) == 0
    assert "left out: The method gtu" in capsys.readouterr().out
    assert main(["compare", mesh, "--from", "0.1,0.2,0", "--methods", "heat"]) == 1
    assert "--from: heat begins at vertices" in capsys.readouterr().err


def test_metrics_from_files_and_from_the_shape(mesh, tmp_path):
    import nibabel

    exact = ["--from", "0", "--exact", "--out", "f.npy", "--quiet"]
    np.save("twice.npy", np.full(143, 2.0))
    np.savetxt("thrice.csv", np.full(143, 3.0))
    np.save("tensor.npy", np.tile(np.diag([4.0, 4.0, 1.0]), (143, 1, 1)))
    four = nibabel.gifti.GiftiDataArray(np.full(143, 4.0, np.float32), "NIFTI_INTENT_NONE")
    nibabel.save(nibabel.gifti.GiftiImage(darrays=[four]), "four.func.gii")
    for file, factor in (("twice.npy", 2), ("thrice.csv", 3), ("tensor.npy", 2), ("four.func.gii", 4)):
        assert main(["field", mesh, "--metric", file, *exact]) == 0
        np.testing.assert_allclose(np.load("f.npy"), factor * APART[0], rtol=1e-6, atol=1e-12)
    np.save("faces.npy", np.full(len(FACES), 2.0))
    np.save("face_tensor.npy", np.tile(np.diag([4.0, 4.0, 1.0]), (len(FACES), 1, 1)))
    for file in ("faces.npy", "face_tensor.npy"):  # distances by points on edges
        assert main(["field", mesh, "--metric", file, *exact]) == 0
        np.testing.assert_allclose(np.load("f.npy"), 2 * APART[0], rtol=2e-3, atol=1e-12)
    tilted = VERTICES @ np.array([[0.8, 0, 0.6], [0, 1, 0], [-0.6, 0, 0.8]])
    write_off(tmp_path / "tilted.off", tilted, FACES)
    assert main(["field", "tilted.off", "--slope-penalty", "5", *exact]) == 0
    np.testing.assert_allclose(np.load("f.npy"), (1 + 5 * 0.6) * APART[0], rtol=1e-6, atol=1e-9)
    assert main(["field", mesh, "--curvature-weight", "5", *exact]) == 0
    np.testing.assert_allclose(np.load("f.npy"), APART[0], atol=1e-9)  # a plane has no curvature


def test_up_and_down_and_with_the_wind(mesh, tmp_path, capsys):
    quiet = ["--quiet", "--out"]
    grade = 0.2
    write_off(tmp_path / "slope.off", VERTICES * [1, 1, 0] + np.outer(VERTICES[:, 0], [0, 0, grade]), FACES)
    low, high = 5 * 13, 5 * 13 + 12
    up, down = (0.6 * np.exp(3.5 * (grade + sign * 0.05)) * 1.2 for sign in (1, -1))
    ends = ["--from", str(low), "--to", str(high)]
    for pace, there, back in (
        ("tobler", up, down),
        ("naismith", (0.72 + 6 * grade) * 1.2, 0.72 * 1.2),
        ("8,2", (np.hypot(1, grade) + 8 * grade) * 1.2, (np.hypot(1, grade) + 2 * grade) * 1.2),
    ):
        for option, expected in (("--from", there), ("--to", back)):
            assert main(["field", "slope.off", option, str(low), "--hiking", pace, *quiet, "f.npy"]) == 0
            assert np.load("f.npy")[high] == pytest.approx(expected, rel=1e-9)
        assert main(["distance", "slope.off", *ends, "--hiking", pace, *quiet, "d.npy"]) == 0
        assert np.load("d.npy")[0] == pytest.approx(there, rel=1e-9)
    np.save("wind.npy", np.tile([0.5, 0.0, 0.0], (len(FACES), 1)))
    for option, speed in (("--from", 1.5), ("--to", 0.5)):
        assert main(["voronoi", mesh, option, str(low), "--metric", "wind.npy", *quiet, "v.npz"]) == 0
        assert np.load("v.npz")["distance"][high] == pytest.approx(1.2 / speed, rel=1e-9)
        assert main(["area", mesh, option, "71", "--radius", "0.2", "--metric", "wind.npy", *quiet, "a.npy"]) == 0
        assert np.load("a.npy")[0, 0] == pytest.approx(np.pi * 0.2**2 / 0.75**1.5, rel=1e-4)
    for command, what in (("index", "Indexes"), ("sample --method poisson --radius 1", "Poisson-disk samplings")):
        assert main([*command.split(), mesh, "--metric", "wind.npy", *quiet, "x.vgi"]) == 1
        assert f"{what} need ways back that cost the same, and this metric goes one way" in capsys.readouterr().err


def test_an_index_belongs_to_its_metric(mesh, capsys):
    np.save("twice.npy", np.full(143, 2.0))
    metric = ["--metric", "twice.npy", "--quiet"]
    assert main(["index", mesh, "--out", "m.vgi", "--patches", "3", "2", *metric]) == 0
    assert main(["field", mesh, "--from", "0", "--index", "m.vgi", "--out", "f.npy", *metric]) == 0
    np.testing.assert_allclose(np.load("f.npy"), 2 * APART[0], **NEAR)
    assert main(["compare", mesh, "--from", "0", "--methods", "mmp", *metric]) == 0
    assert "mean error 0 %" in re.sub(r"\S+e-1[0-9] %", "0 %", capsys.readouterr().out)
    assert main(["field", mesh, "--from", "0", "--index", "m.vgi", "--out", "f.npy", "--quiet"]) == 1
    assert "built for another mesh" in capsys.readouterr().err


def test_the_default_name_is_made_of_mesh_and_command(mesh, capsys):
    assert main(["sample", mesh, "--count", "3"]) == 0
    assert np.load("plane-sample.npy").shape == (3,)
    assert capsys.readouterr().out.startswith("plane-sample.npy: 3 samples")


@pytest.mark.parametrize(
    ("arguments", "status", "line"),
    [
        (["field", "missing.off", "--from", "0"], 1, "missing.off: there is no such file"),
        (["field", "plane.off", "--from", "143"], 1, "there is no vertex 143"),
        (["field", "plane.off", "--from", "here"], 1, "--from here: is neither a vertex id, nor a position"),
        (["field", "plane.off", "--from", "0", "--out", "f.xyz"], 1, "f.xyz: has no known ending; give one of .npy"),
        (["field", "plane.off", "--from", "0", "--out", "no/f.npy"], 1, "no/f.npy: cannot be written"),
        (["distance", "plane.off", "--from", "0", "1", "--to", "1", "2", "3"], 1, "as many of one as of the other"),
        (["matrix", "plane.off", "--out", "m.gii"], 1, "has no value for each vertex"),
        (["neighbours", "plane.off", "--radius", "1", "--out", "n.npy"], 1, "sparse matrix goes into .npz"),
        (["sample", "plane.off", "--method", "poisson"], 1, "--radius: is missing"),
        (["loop", "plane.off"], 1, "--at: is missing; name the point"),
        (["loop", "plane.off", "--curve", "0", "1", "14"], 1, "slips off: pulled tight, it contracts to a point"),
        (["girth", "plane.off", "--at", "70"], 1, "is not closed: it meets the border at the edge between"),
        (["girth", "plane.off", "--at", "70", "--normal", "0,1"], 2, "'0,1' is not a vector x,y,z"),
        (["area", "plane.off", "--radius", "1"], 1, "--from: is missing; name the sources, or points to go to by --to"),
        (["area", "plane.off", "--from", "0"], 1, "--radius: is missing; give how far"),
        (["area", "plane.off", "--from", "0", "--inside", "0", "1"], 2, "not allowed with argument --from"),
        (["area", "plane.off", "--regions", "no.npy"], 1, "--regions no.npy: there is no such file"),
        (["through", "plane.off", "--points", "0", "0.5,0.5,1", "--max-snap", "0.1"], 1, "away from the surface"),
        (["polygon", "plane.off", "--points", "0", "142", "12", "130"], 1, "of the polygon cross or touch"),
        (["polygon", "plane.off", "--hull", "--points", "0", "1", "2"], 1, "The points lie on one line"),
        (["cut", "plane.off"], 1, "--points: is missing; name points to cut along"),
        (["cut", "plane.off", "--levels", "1"], 1, "--from: is missing; name the sources"),
        (["cut", "plane.off", "--points", "0", "142", "--region", "5"], 1, "--region 5: is not there; the cut has"),
        (["cut", "plane.off", "--points", "0", "142", "--out", "c.gii"], 1, "has no value for each vertex"),
        (["directions", "plane.off", "--at", "0", "1"], 1, "point: has 2 points; give one"),
        (["directions", "plane.off", "--at", "0", "--out", "d.xyz"], 1, "d.xyz: has no known ending"),
        (["signed", "plane.off"], 1, "--curve: is missing; name points of a closed curve, or a --region"),
        (["signed", "plane.off", "--curve", "0", "1", "--region", "r.npy"], 2, "not allowed with argument"),
        (["signed", "plane.off", "--region", "no.npy"], 1, "--region no.npy: there is no such file"),
        (["signed", "plane.off", "--region", "few.csv"], 1, "give one for each of the 240 faces"),
        (["spline", "plane.off", "--points", "0"], 1, "points"),
        (["mean", "plane.off", "--points", "143"], 1, "there is no vertex 143"),
        (["clusters", "plane.off", "--count", "144"], 1, "There are 143 points to be divided into 144 clusters"),
        (["clusters", "plane.off", "--count", "0"], 2, "'0' is not a whole number from 1 on"),
        (["cut-locus", "plane.off", "--from", "0", "--min-angle", "181"], 2, "'181' is not an angle from 0 to 180"),
        (["field", "text.off", "--from", "0"], 1, "text.off: cannot be read as a mesh"),
        (["field", "short.off", "--from", "0"], 1, "ends before the numbers of vertices and faces"),
        (["field", "plane.off"], 2, "vorogeo field: error: one of the arguments --from --to is required"),
        (["neighbours", "plane.off", "--radius", "-1"], 2, "'-1' is not a length of 0 or more"),
        (["field", "plane.off", "--from", "0", "--metric", "no.npy"], 1, "--metric no.npy: there is no such file"),
        (["field", "plane.off", "--from", "0", "--metric", "text.off"], 1, "cannot be read"),
        (["field", "plane.off", "--from", "0", "--metric", "few.csv"], 1, "give a cost for each of the 143 vertices"),
        (["field", "plane.off", "--from", "0", "--slope-penalty", "1", "--metric", "few.csv"], 2, "not allowed with"),
        (["field", "plane.off", "--from", "0", "--to", "1"], 2, "not allowed with"),
        (["voronoi", "plane.off"], 2, "one of the arguments --from --to is required"),
        (["cut", "plane.off", "--points", "0", "9", "--to", "1"], 1, "--to: says nothing beside --points"),
        (["cut", "plane.off", "--from", "0", "--levels", "1", "--closed"], 1, "--closed: says nothing beside --levels"),
        (["field", "plane.off", "--from", "0", "--hiking", "fast"], 2, "'fast' is not tobler, naismith or two numbers"),
        (["field", "plane.off", "--from", "0", "--hiking=-1,2"], 1, "The uphill cost is -1"),
        (["guess", "plane.off"], 2, "invalid choice: 'guess'"),
        ([], 2, "no command given"),
    ],
)
def test_errors_are_one_line_and_a_status(mesh, tmp_path, capsys, arguments, status, line):
    (tmp_path / "text.off").write_text("no mesh\n")
    (tmp_path / "few.csv").write_text("1\n2\n")
    (tmp_path / "short.off").write_text("OFF\n# nothing follows\n")
    before = {file.name for file in tmp_path.iterdir()}
    assert main(arguments) == status
    said = capsys.readouterr().err
    assert line in said
    assert sum(map(bool, said.splitlines())) <= (2 if not arguments else 1)
    assert {file.name for file in tmp_path.iterdir()} == before


def test_measures_of_a_plane(mesh, tmp_path, capsys):
    def printed(*arguments):
        assert main([*arguments]) == 0
        return [float(line.split()[-1]) for line in capsys.readouterr().out.splitlines()]

    assert printed("through", mesh, "--points", "0", "12", "142") == pytest.approx([2.2])
    assert printed("through", mesh, "--points", "0", "12", "142", "--closed") == pytest.approx([2.2 + np.hypot(1.2, 1)])
    assert printed("through", mesh, "--points", "0", "15", "142", "--guides") == pytest.approx([np.hypot(1.2, 1)])
    circle = printed("area", mesh, "--from", "0.6,0.5,0", "--radius", "0.3")
    assert circle == pytest.approx([np.pi * 0.09, np.pi * 0.6], rel=1e-3)
    band = printed("area", mesh, "--curve", "0.4,0.5,0", "0.8,0.5,0", "--radius", "0.2")
    assert band == pytest.approx([0.4 * 0.4 + np.pi * 0.04, 0.8 + np.pi * 0.4], rel=2e-3)
    corners = ["0.1,0.1,0", "1.1,0.1,0", "1.1,0.8,0", "0.1,0.8,0"]
    assert printed("area", mesh, "--inside", *corners) == pytest.approx([0.7, 3.4])
    np.save("halves.npy", (VERTICES[FACES][:, :, 0].mean(axis=1) > 0.5).astype(float))
    assert main(["area", mesh, "--regions", "halves.npy", "--out", "r.csv", "--quiet"]) == 0
    assert Path("r.csv").read_text().splitlines()[0] == "area,border_length,volume"
    np.testing.assert_allclose(np.loadtxt("r.csv", delimiter=",", skiprows=1)[:, :2], [[0.5, 3.0], [0.7, 3.4]])
    apart = printed("sets", mesh, "--from", "0", "12", "--to", "142", "130")
    assert apart == pytest.approx([1, 1, 1])
    assert printed("polygon", mesh, "--points", *corners) == pytest.approx([0.7, 3.4])
    assert printed("polygon", mesh, "--hull", "--points", corners[2], "0.5,0.5,0", *corners) == pytest.approx(
        [0.7, 3.4]
    )
    assert main(["polygon", mesh, "--points", *corners, "--out", "p.npz", "--quiet"]) == 0
    found = np.load("p.npz")
    np.testing.assert_allclose(found["angles"], np.pi / 2)
    assert found["length"] == pytest.approx([1, 0.7, 1, 0.7])
    assert main(["profile", mesh, "--points", *corners[:3], "--up", "1,0,0", "--quiet"]) == 0
    assert Path("plane-profile.csv").read_text().splitlines()[0] == "length,height,angle,curvature,thickness"
    length, height, angle, curvature, thickness = np.loadtxt("plane-profile.csv", delimiter=",", skiprows=1).T
    assert length[-1] == pytest.approx(1.7)
    np.testing.assert_allclose(height, np.minimum(0.1 + length, 1.1), atol=1e-9)
    np.testing.assert_allclose(angle, np.pi / 2)
    assert (curvature == 0).all()
    assert np.isinf(thickness).all()


def read_cut(file):
    """Vertices, and faces with their quality, which meshio does not read."""
    head, _, body = Path(file).read_bytes().partition(b"end_header\n")
    count = int(re.search(rb"vertex (\d+)", head)[1])
    row = np.dtype([("size", "u1"), ("ids", "<i4", 3), ("quality", "<f4")])
    return np.frombuffer(body, "<f8", 3 * count).reshape(-1, 3), np.frombuffer(body[24 * count :], row)


def test_cuts_go_to_files(mesh, capsys):
    line = ["--points", "0.55,0,0", "0.55,1,0"]
    assert main(["cut", mesh, *line]) == 0
    assert re.search(r"2 regions, areas 0\.[56]5 0\.[56]5\b", capsys.readouterr().out)
    points, cells = read_cut("plane-cut.ply")
    assert len(cells) > len(FACES)
    np.testing.assert_array_equal(points[: len(VERTICES)], VERTICES)
    assert set(cells["quality"].tolist()) == {0, 1}
    assert main(["cut", mesh, "--from", "0", "--levels", "0.3", "0.6", "--out", "c.npz", "--quiet"]) == 0
    found = np.load("c.npz")
    middle = np.linalg.norm(found["vertices"][found["faces"]].mean(axis=1)[:, :2], axis=1)
    for region, (low, high) in enumerate([(0, 0.3), (0.28, 0.6), (0.57, 2)]):
        assert (middle[found["region"] == region] <= high).all()
        assert (middle[found["region"] == region] >= low).all()
    assert main(["cut", mesh, "--from", "0", "--levels", "0.3", "--region", "0", "--out", "disk.ply", "--quiet"]) == 0
    assert np.linalg.norm(read_cut("disk.ply")[0], axis=1).max() == pytest.approx(0.3)


def test_cuts_keep_what_vertices_have(mesh):
    rows = np.zeros(len(VERTICES), [*((axis, "<f8") for axis in "xyz"), ("nz", "<f4"), ("red", "u1"), ("s", "<f8")])
    for k, axis in enumerate("xyz"):
        rows[axis] = VERTICES[:, k]
    rows["nz"], rows["s"] = 1, 3 * VERTICES[:, 0] - VERTICES[:, 1]
    rows["red"] = np.rint(200 * VERTICES[:, 0])
    cells = np.zeros(len(FACES), [("size", "u1"), ("ids", "<i4", 3)])
    cells["size"], cells["ids"] = 3, FACES
    kinds = ("double", "double", "double", "float", "uchar", "double")
    names = [f"property {kind} {name}" for kind, name in zip(kinds, rows.dtype.names, strict=True)]
    head = ["ply", "format binary_little_endian 1.0", f"element vertex {len(rows)}", *names]
    head += [f"element face {len(cells)}", "property list uchar int vertex_indices", "end_header\n"]
    Path("rich.ply").write_bytes("\n".join(head).encode() + rows.tobytes() + cells.tobytes())
    for part in ([], ["--region", "1"]):
        line = ["--points", "0.55,0,0", "0.55,1,0", "--out", "cut.ply", "--quiet"]
        assert main(["cut", "rich.ply", *line, *part]) == 0
        head, _, body = Path("cut.ply").read_bytes().partition(b"end_header\n")
        assert [line.encode() in head for line in names] == [True] * len(names)
        found = np.frombuffer(body, rows.dtype, int(re.search(rb"vertex (\d+)", head)[1]))
        np.testing.assert_allclose(found["s"], 3 * found["x"] - found["y"], atol=1e-12)
        np.testing.assert_allclose(found["red"], 200 * found["x"], atol=1.01)
        assert (found["nz"] == 1).all()


def test_directions_of_a_plane(mesh, capsys):
    """The log map, its texture coordinates, and what is built on directions."""

    def write(*arguments):
        assert main([*arguments, "--quiet"]) == 0

    middle = 71  # at 0.6, 0.5
    away = VERTICES - VERTICES[middle]
    write("directions", mesh, "--at", str(middle), "--out", "d.npz")
    found = np.load("d.npz")
    vector, distance, angle = (found[name] for name in ("vector", "distance", "angle"))
    np.testing.assert_allclose(distance, APART[middle], atol=1e-12)
    np.testing.assert_allclose(vector @ vector.T, away @ away.T, atol=1e-12)  # up to a turn
    np.testing.assert_allclose(np.exp(1j * angle) * distance, vector @ [1, 1j], atol=1e-12)
    write("index", mesh, "--out", "plane.vgi", "--patches", "3", "2")
    for options in ([], ["--exact"]):
        write("directions", mesh, "--at", str(middle), "--index", "plane.vgi", "--out", "i.npy", *options)
        np.testing.assert_allclose(np.load("i.npy"), vector, atol=1e-12 if options else 0.05)
    write("directions", mesh, "--at", str(middle), "--max-distance", "0.25", "--out", "d.ply")
    ply = meshio.read("d.ply").point_data
    near = APART[middle] <= 0.25
    np.testing.assert_array_equal(ply["quality"] == -1, ~near)
    uv = np.column_stack([ply["texture_u"], ply["texture_v"]])
    np.testing.assert_allclose(uv[near], 0.5 + vector[near] / 0.5, atol=1e-6)
    assert (uv[~near] == 0).all()
    corners = ["0.2,0.2,0", "1.0,0.2,0", "1.0,0.8,0", "0.2,0.8,0"]
    off = np.abs(VERTICES[:, :2] - [0.6, 0.5]) - [0.4, 0.3]
    expected = np.minimum(off.max(axis=1), 0) + np.linalg.norm(np.maximum(off, 0), axis=1)
    write("signed", mesh, "--curve", *corners, "--out", "s.npy")
    np.testing.assert_allclose(np.load("s.npy"), expected, atol=1e-6)
    np.save("inside.npy", (np.abs(VERTICES[FACES].mean(axis=1)[:, :2] - [0.6, 0.5]) < [0.4, 0.3]).all(axis=1))
    write("signed", mesh, "--region", "inside.npy", "--out", "s.npy")
    np.testing.assert_allclose(np.load("s.npy"), expected, atol=1e-6)
    write("cut-locus", mesh, "--from", "0", "11", "--out", "c.npz")
    locus = np.load("c.npz")
    np.testing.assert_allclose(locus["points"][:, 0], 0.55, atol=1e-9)
    np.testing.assert_allclose(locus["distance"], np.hypot(0.55, locus["points"][:, 1]), atol=1e-9)
    write("cut-locus", mesh, "--from", "0", "11", "--min-angle", "92")
    head, _, body = Path("plane-cut-locus.ply").read_bytes().partition(b"end_header\n")
    count = int(re.search(rb"vertex (\d+)", head)[1])
    points = np.frombuffer(body, [("at", "<f8", 3), ("quality", "<f4")], count)
    np.testing.assert_allclose(points["quality"], np.hypot(0.55, points["at"][:, 1]), rtol=1e-6)
    assert points["at"][:, 1].max() == pytest.approx(0.5)  # at 0.55 they are seen at a right angle
    capsys.readouterr()
    assert main(["spline", mesh, "--points", "13", "19", "25"]) == 0
    assert float(capsys.readouterr().out) == pytest.approx(1.2)
    write("spline", mesh, "--points", *corners, "--closed", "--near", "--out", "near.npz")
    write("spline", mesh, "--points", *corners, "--closed", "--out", "through.npz")
    assert np.load("near.npz")["length"] < 2.8 < np.load("through.npz")["length"] + 0.3
    capsys.readouterr()
    for options, place in ((), VERTICES[[0, 5, 60]].mean(axis=0)), (("--median",), VERTICES[5]):
        points = ("0", "5", "60") if not options else ("4", "5", "6", "18")
        assert main(["mean", mesh, "--points", *points, *options]) == 0
        np.testing.assert_allclose([float(x) for x in capsys.readouterr().out.split(",")], place, atol=1e-8)
    write("clusters", mesh, "--count", "5", "--out", "k.npz", "--exact")
    found = np.load("k.npz")
    apart = np.linalg.norm(VERTICES[:, None] - found["centre_points"], axis=2)
    np.testing.assert_allclose(apart[np.arange(143), found["label"]], apart.min(axis=1), atol=1e-9)
    write(
        "clusters", mesh, "--count", "2", "--points", "0", "1", "2", "140", "141", "142", "--medoids", "--out", "m.npy"
    )
    labels = np.load("m.npy")
    assert (labels == np.repeat(labels[[0, -1]], 3)).all()
    assert labels[0] != labels[-1]


def test_loops_and_girths_of_a_tube(tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    vertices, faces = prism(12, 9, 4.0)
    write_off(tmp_path / "tube.off", vertices, faces)
    around = np.linalg.norm(vertices[:12] - np.roll(vertices[:12], 1, axis=0), axis=1).sum()
    ring = [str(vertex) for vertex in range(48, 60)]
    for arguments in (["--at", "50"], ["--curve", *ring], ["--at", "50", "--curve", *ring]):
        assert main(["loop", "tube.off", *arguments]) == 0
        assert float(capsys.readouterr().out) == pytest.approx(around)
    assert main(["girth", "tube.off", "--at", "50", "--normal", "0,0,1"]) == 0
    said = [line.split() for line in capsys.readouterr().out.splitlines()]
    assert [name for name, _ in said] == ["section", "tape", "loop"]
    assert [float(value) for _, value in said] == pytest.approx([around] * 3)
    assert main(["girth", "tube.off", "--at", "50", "--out", "g.csv", "--quiet"]) == 0
    assert set(np.loadtxt("g.csv", delimiter=",", skiprows=1)[:, 0]) == {0, 1}


def test_program_and_module_are_one(mesh):
    script = [str(Path(sys.executable).with_name("vorogeo"))]
    for program in ([sys.executable, "-m", "vorogeo"], script):
        done = subprocess.run([*program, "--help"], capture_output=True, text=True, check=True)
        for command in [
            "field",
            "distance",
            "path",
            "matrix",
            "neighbours",
            "voronoi",
            "sample",
            "through",
            "loop",
            "girth",
            "area",
            "sets",
            "polygon",
            "profile",
            "cut",
            "index",
            "compare",
            "info",
        ]:
            assert f"  {command}  " in done.stdout
        assert max(map(len, done.stdout.splitlines())) <= 120
    done = subprocess.run([*script, "field", "--help"], capture_output=True, text=True, check=True)
    assert done.stdout.startswith("usage: vorogeo field MESH... --from POINT... [options]\n")
    done = subprocess.run([*script, "field", mesh, "--from", "999"], capture_output=True, text=True, check=False)
    assert (done.returncode, len(done.stderr.splitlines())) == (1, 1)
