"""Meshes of other packages, also by stand-ins, arrays of every kind, polygons, the recipes of docs/packages.md."""

import re
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest
import vorogeo
from scipy.sparse.csgraph import minimum_spanning_tree

from sample_meshes import bent_grid, cube, prism_distances

DOCS = Path(__file__).resolve().parents[2] / "docs"
SNIPPETS = re.findall(r"```python\n(.*?)```", (DOCS / "packages.md").read_text(), flags=re.DOTALL)
VERTICES, FACES = bent_grid(9, 7)


def unrolled(source):
    return prism_distances(24, 21, 4.0, source)


@pytest.fixture
def recipe(tmp_path, monkeypatch):
    """Runs the snippet of a package after the tube of the guide; all names that they define."""

    def run(package):
        pytest.importorskip(package.split(".")[0])
        monkeypatch.chdir(tmp_path)
        (snippet,) = (one for one in SNIPPETS if re.match(rf"(import|from) {re.escape(package)}\b", one))
        tube = re.search(r"```python\n(.*?)```", (DOCS / "guide.md").read_text(), flags=re.DOTALL)[1]
        names = {}
        exec(compile(tube + snippet, f"{package} of packages.md", "exec"), names)
        return SimpleNamespace(**names)

    return run


def test_results_go_back_to_trimesh(recipe):
    found = recipe("trimesh").mesh.vertex_attributes["distance"]
    np.testing.assert_allclose(found, unrolled(0), atol=1e-9)


def test_results_go_back_to_pyvista(recipe):
    names = recipe("pyvista")
    np.testing.assert_allclose(names.mesh["distance"], unrolled(0), atol=1e-9)
    np.testing.assert_array_equal(names.drawn.cell_data["region"], names.regions.face_region)
    np.testing.assert_array_equal(names.drawn.point_data["distance"], names.regions.distance)
    assert names.lines.compute_cell_sizes()["Length"].sum() == pytest.approx(unrolled(0)[250])


def test_results_go_back_to_meshio(recipe):
    names = recipe("meshio")
    np.testing.assert_allclose(names.meshio.read("tube.vtu").point_data["distance"], unrolled(0), atol=1e-9)


def test_results_go_back_to_pymeshlab(recipe):
    names = recipe("pymeshlab")
    np.testing.assert_allclose(names.mesh_set.current_mesh().vertex_scalar_array(), unrolled(0), atol=1e-9)


def test_results_go_back_to_torch(recipe):
    np.testing.assert_allclose(recipe("torch").distance.numpy(), unrolled(0), atol=1e-9)


def test_quads_measure_as_the_tube_they_make(recipe):
    names = recipe("numpy")
    np.testing.assert_allclose(names.from_quads, unrolled(0), atol=1e-9)
    assert names.regions_of_halves.shape == (len(names.quads), 2)
    middle = names.vertices[names.quads][:, :, 2].mean(axis=1)
    np.testing.assert_array_equal(names.regions_of_halves[middle > 3.5], 1)  # the second point is in the middle


def test_sparse_weights_go_both_ways(recipe):
    names = recipe("scipy.sparse")
    positions = names.points.positions(names.vertices, names.faces)
    np.testing.assert_allclose(names.weights @ names.vertices, positions, atol=1e-12)
    np.testing.assert_allclose(names.heights, [2.3, 1.7], atol=0.01)
    at_corner = vorogeo.SurfacePoints.from_sparse(np.eye(len(names.vertices))[[17]], names.faces)
    np.testing.assert_allclose(names.surface.distance(at_corner, 17), 0, atol=1e-12)
    apart = np.zeros((2, len(names.vertices)))
    apart[0, 0] = 1
    apart[1, [0, 250]] = 0.5
    with pytest.raises(vorogeo.InvalidInput, match=r"weights\[1\]: weighs vertices \[0, 250\], which are not corners"):
        vorogeo.SurfacePoints.from_sparse(apart, names.faces)


def test_precomputed_distances_cluster(recipe):
    names = recipe("sklearn.cluster")
    assert names.labels.tolist() == names.same.tolist() == [0, 0, 0, 1, 1, 2]


def test_pairs_are_a_graph(recipe):
    names = recipe("networkx")
    assert sorted(map(sorted, names.groups)) == [[0, 1, 2], [3, 4], [5]]
    apart = np.array([unrolled(v)[names.points] for v in names.points])
    assert names.tree.size(weight="weight") == pytest.approx(minimum_spanning_tree(apart).sum(), rel=1e-3)


def test_every_snippet_is_run_by_one_of_these():
    tests = Path(__file__).read_text()
    for package in (snippet.split()[1] for snippet in SNIPPETS):
        assert f'recipe("{package}")' in tests


def of_pyvista():
    pyvista = pytest.importorskip("pyvista")
    return pyvista.PolyData.from_regular_faces(VERTICES, FACES)


def of_pymeshlab():
    pymeshlab = pytest.importorskip("pymeshlab")
    return pymeshlab.Mesh(VERTICES, FACES)


class OnlyDLPack:
    """An array that follows the array API and knows nothing of NumPy."""

    def __init__(self, array):
        self.array, self.shape = array, array.shape

    def __dlpack__(self, **how):
        return self.array.__dlpack__(**how)

    def __dlpack_device__(self):
        return self.array.__dlpack_device__()


class Recorded:
    """A tensor of torch that records gradients."""

    requires_grad = True

    def __init__(self, array):
        self.array, self.shape = array, array.shape

    def __array__(self, dtype=None, copy=None):
        raise RuntimeError("Can't call numpy() on Tensor that requires grad.")

    def detach(self):
        """What can be read."""
        return self.array


def tensors(array):
    return SimpleNamespace(numpy=lambda: array)


MESHES = {
    "a pair": lambda: (VERTICES, FACES),
    "a surface": lambda: vorogeo.Surface(VERTICES, FACES),
    "PyVista": of_pyvista,
    "PyMeshLab": of_pymeshlab,
    "Open3D": lambda: SimpleNamespace(vertices=VERTICES, triangles=FACES),
    "trimesh": lambda: SimpleNamespace(vertices=VERTICES, faces=FACES, triangles=VERTICES[FACES]),
    "tensors of Open3D": lambda: SimpleNamespace(
        vertex={"positions": tensors(VERTICES)}, triangle={"indices": tensors(FACES)}
    ),
    "the array API": lambda: (OnlyDLPack(VERTICES.copy()), OnlyDLPack(FACES.copy())),
    "torch with gradients": lambda: (Recorded(VERTICES), Recorded(FACES)),
    "Fortran's order": lambda: (np.asfortranarray(VERTICES), np.asfortranarray(FACES)),
    "strides": lambda: (np.repeat(VERTICES, 2, axis=0)[::2], np.repeat(FACES, 2, axis=1)[:, ::2]),
}


@pytest.mark.parametrize("kind", MESHES)
def test_any_mesh_is_its_vertices_and_faces(kind):
    mesh = MESHES[kind]()
    vertices, faces = vorogeo.mesh_arrays(mesh)
    np.testing.assert_array_equal(vertices, VERTICES)
    np.testing.assert_array_equal(faces, FACES)
    expected = vorogeo.exact_distance_field(VERTICES, FACES, 0)
    np.testing.assert_array_equal(vorogeo.Surface(mesh).distance_field(0), expected)
    assert vorogeo.check_mesh(mesh) == vorogeo.check_mesh(VERTICES, FACES)


def test_pyvista_gives_strips_and_polygons_as_triangles():
    pyvista = pytest.importorskip("pyvista")
    strips = of_pyvista().strip()
    assert strips.n_strips > 0
    vertices, faces = vorogeo.mesh_arrays(strips)
    np.testing.assert_array_equal(vertices, VERTICES)
    assert sorted(map(sorted, faces.tolist())) == sorted(map(sorted, FACES.tolist()))
    box = pyvista.Cube()
    assert len(vorogeo.mesh_arrays(box).faces) == 12
    with pytest.raises(vorogeo.InvalidInput, match=r"is a UnstructuredGrid; .*extract_surface"):
        vorogeo.Surface(box.cast_to_unstructured_grid())


def test_files_that_are_mapped_and_arrays_that_are_read_only(tmp_path):
    np.save(tmp_path / "v.npy", VERTICES)
    np.save(tmp_path / "f.npy", FACES)
    mapped = [np.load(tmp_path / name, mmap_mode="r") for name in ("v.npy", "f.npy")]
    surface = vorogeo.Surface(*mapped)
    del mapped
    (tmp_path / "v.npy").unlink()
    np.testing.assert_array_equal(
        surface.distance_field(0, method="exact"), vorogeo.exact_distance_field(VERTICES, FACES, 0)
    )


def test_polygons_keep_their_vertices_and_their_order():
    corners, triangles = cube()
    quads = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    mixed = [quads[0], *([q[0], q[1], q[2]] for q in quads[1:]), *([q[0], q[2], q[3]] for q in quads[1:])]
    for faces in (quads, np.array(quads), np.array(quads, order="F"), mixed):
        np.testing.assert_allclose(
            vorogeo.Surface(corners, faces).distance_field(0),
            [0, 1, 1, np.sqrt(2), 1, np.sqrt(2), np.sqrt(2), np.sqrt(5)],
        )
    np.testing.assert_array_equal(vorogeo.mesh_arrays(corners, quads).faces, triangles)
    np.testing.assert_array_equal(vorogeo.mesh_arrays(corners, mixed).faces[1:3], [[0, 3, 2], [4, 6, 7]])
    meshio = pytest.importorskip("meshio")
    np.testing.assert_array_equal(
        vorogeo.mesh_arrays(meshio.Mesh(corners, [("quad", quads), ("line", [[0, 1]])])).faces, triangles
    )


def area(vertices, faces):
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    return np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2


def test_concave_polygons_are_filled_once():
    flat = np.array([[0, 0, 0], [3, 1, 0], [0, 2, 0], [1, 1, 0], [2, 5, 0]], dtype=float)
    dart = [0, 1, 2, 3]
    vertices, faces = vorogeo.mesh_arrays(flat, [dart, [0, 1, 4]])
    assert area(vertices, faces[:2]) == pytest.approx(2)
    assert vorogeo.Surface(flat, [dart]).distance(0, 2) == pytest.approx(2 * np.sqrt(2))  # round the inward corner
    comb = np.array([(0, 0), (6, 0), (6, 3), (5, 1), (4, 3), (3, 1), (2, 3), (1, 1), (0, 3)], dtype=float)
    with pytest.warns(UserWarning, match=r"faces\[0\]: is a polygon that no fan of triangles fills"):
        vorogeo.mesh_arrays(np.column_stack([comb, np.zeros(9)]), [list(range(9))])


def test_what_is_no_mesh_is_refused():
    with pytest.raises(vorogeo.InvalidInput, match="faces: is missing, and the only argument is a str"):
        vorogeo.Surface("bunny.ply")
