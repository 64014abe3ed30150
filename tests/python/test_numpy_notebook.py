"""In a notebook: bars, what objects say of themselves, and results handed to PyVista and polyscope as they are."""

import re

import numpy as np
import pytest
import vorogeo

from sample_meshes import bent_grid

MESH = bent_grid(30, 20)
POINTS = [3, 100, 333, 560]


@pytest.fixture(scope="module")
def index():
    return vorogeo.GeodesicIndex(*MESH, patches=(4, 4))


@pytest.mark.parametrize(
    "call",
    [
        lambda i: i.distance_matrix(POINTS, progress=True),
        lambda i: i.distances(POINTS, POINTS[::-1], progress=True),
        lambda i: i.fields(POINTS, progress=True),
        lambda i: i.pairs_within(POINTS, 0.5, progress=True),
        lambda i: i.nearest(POINTS, [1, 2, 3], progress=True),
        lambda i: i.voronoi(POINTS, progress=True),
        lambda i: i.sample_farthest(5, progress=True),
        lambda i: i.sample_poisson_disk(0.3, progress=True),
        lambda i: i.relax(POINTS, rounds=2, progress=True),
        lambda i: i.extent(fields=3, progress=True),
        lambda i: i.eccentricity(POINTS, progress=True),
        lambda i: i.path(POINTS, POINTS[::-1], progress=True),
        lambda i: i.exact_path(POINTS, POINTS[::-1], progress=True),
    ],
)
def test_long_calls_draw_a_bar_that_ends_full(index, capfd, call):
    pytest.importorskip("tqdm")
    call(index)
    bars = capfd.readouterr().err
    assert re.findall(r"(\d+)%", bars)[-1] == "100"


def test_objects_say_what_they_hold(index):
    said = repr(index)
    s = index.statistics
    for part in (f"{s.vertices} vertices", f"{s.faces} faces", f"patches ({s.first_layer_patches}, ", s.form, "MiB"):
        assert part in said
    path = index.exact_path(0, 599)
    assert repr(path) == f"GeodesicPath(length {path.length:g}, {len(path.points)} points, certified: {path.certified})"
    assert repr(index.snap([[0, 0, 1], [1, 1, 1]])).startswith(
        "SurfacePoints(2 points, moved to the surface by at most"
    )
    assert repr(vorogeo.SurfacePoints(np.array([0]), np.array([[1.0, 0, 0]]))) == "SurfacePoints(1 points)"


def test_results_fit_pyvista(index):
    pyvista = pytest.importorskip("pyvista")
    vertices, faces = MESH
    surface = pyvista.PolyData.from_regular_faces(vertices, faces)
    regions = index.voronoi(POINTS)
    surface["distance"] = index.distance_field(POINTS)
    surface.cell_data["region"] = regions.face_region
    assert surface.n_points == len(surface["distance"])
    assert surface.n_cells == len(surface.cell_data["region"])
    assert regions.borders.to_pyvista().length > 0
    path = index.path(0, 599)
    line = path.to_pyvista()
    assert line.n_lines == 1
    assert line.compute_cell_sizes()["Length"].sum() == pytest.approx(path.length)
    isolines = index.isolines(surface["distance"], 5)
    lines = isolines.to_pyvista()
    lines["value"] = isolines.values
    assert lines.compute_cell_sizes()["Length"].sum() == pytest.approx(isolines.length)
    cloud = pyvista.PolyData(index.snap(np.add(vertices[:3], [0, 0, 0.1])).positions(vertices, faces))
    assert cloud.n_points == 3


def test_results_fit_polyscope(index, monkeypatch, tmp_path):
    polyscope = pytest.importorskip("polyscope")
    monkeypatch.chdir(tmp_path)  # it writes its settings where it runs
    polyscope.init("openGL_mock")  # draws nothing and needs no screen
    vertices, faces = MESH
    surface = polyscope.register_surface_mesh("surface", vertices, faces)
    regions = index.voronoi(POINTS)
    surface.add_distance_quantity("distance", regions.distance)
    surface.add_scalar_quantity("region", regions.face_region, defined_on="faces", datatype="categorical")
    polyscope.register_curve_network("borders", regions.borders.points, regions.borders.edges)
    path = index.path(0, 599)
    network = polyscope.register_curve_network("path", path.points, edges="line")
    assert network.n_nodes() == len(path.points)
    isolines = index.isolines(regions.distance, 5)
    network = polyscope.register_curve_network("isolines", isolines.points, isolines.edges)
    network.add_scalar_quantity("value", isolines.values)
    assert network.n_edges() == len(isolines.edges)
    points = index.sample_farthest(6).points.positions(vertices, faces)
    assert polyscope.register_point_cloud("samples", points).n_points() == 6
    polyscope.remove_all_structures()
    polyscope.shutdown()
