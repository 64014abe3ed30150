"""vorogeo.exact_distance_field equals pygeodesic, an independent exact solver (MMP), on real meshes.

pygeodesic runs in a process of its own, since it may crash on a mesh that is not manifold. It is given the source's
component only: for a vertex that it cannot reach, it reads the nearest source from uninitialised memory.
"""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
import vorogeo
from numpy.typing import NDArray
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from test_numpy_paths import check_path

from sample_meshes import Mesh, real_mesh

SOURCE = 1500
#: Vertices whose faces form two fans: paths of VoroGeo may pass through them, those of pygeodesic may not.
NON_MANIFOLD_VERTEX = {"cow": 253}
#: Edges with three or more faces, which pygeodesic does not know: it may crash, raise or not end.
NON_MANIFOLD_EDGES = ["office_chair", "dragon_raw"]
#: Meshes that may take it too long, and how many seconds these get.
LARGE = ["igea", "dragon_raw"]
SECONDS_FOR_LARGE = 20
#: The same for meshes with needles, and the number of distances on which it errs for which paths are traced.
SECONDS_FOR_NEEDLES = 60
PROVED = 3

CHILD = """
import sys
import numpy as np
from pygeodesic.geodesic import PyGeodesicAlgorithmExact
data = np.load(sys.argv[1])
distances, _ = PyGeodesicAlgorithmExact(data["vertices"], data["faces"]).geodesicDistances(data["sources"])
np.save(sys.argv[2], distances)
"""


class PygeodesicFailedError(Exception):
    """Why pygeodesic gave no distances."""


def pygeodesic_field(mesh: Mesh, source: int, folder: Path, seconds: float) -> NDArray[np.float64]:
    """Distances from a vertex by pygeodesic; infinity where no path leads."""
    pytest.importorskip("pygeodesic.geodesic")
    vertices, faces = mesh
    component = component_of(len(vertices), faces, source)
    number = np.cumsum(component) - 1
    given, result = folder / "mesh.npz", folder / "distances.npy"
    np.savez(
        given,
        vertices=vertices[component],
        faces=number[faces[component[faces[:, 0]]]],
        sources=number[[source]],
    )
    command = [sys.executable, "-c", CHILD, str(given), str(result)]
    try:
        run = subprocess.run(command, capture_output=True, text=True, timeout=seconds)
    except subprocess.TimeoutExpired as error:
        raise PygeodesicFailedError(f"needs more than {seconds} s") from error
    if run.returncode < 0:
        raise PygeodesicFailedError(f"crashed with signal {-run.returncode}")
    if run.returncode > 0:
        raise PygeodesicFailedError(f"raised {run.stderr.strip().splitlines()[-1:]}")
    field = np.full(len(vertices), np.inf)
    field[component] = np.load(result)
    return field


def component_of(vertex_count: int, faces: NDArray[np.int32], vertex: int) -> NDArray[np.bool_]:
    """Which vertices are connected with the one given."""
    ends = faces[:, [0, 1]].ravel(), faces[:, [1, 2]].ravel()
    edges = coo_array((np.ones(len(ends[0])), ends), shape=(vertex_count, vertex_count))
    _, labels = connected_components(edges, directed=False)
    return labels == labels[vertex]


def assert_equal_fields(field: NDArray[np.float64], reference: NDArray[np.float64]) -> None:
    np.testing.assert_array_equal(np.isinf(field), np.isinf(reference))
    np.testing.assert_allclose(field, reference, rtol=1e-9, atol=0)


@pytest.mark.parametrize(
    "name",
    [
        "bunny10k_textured.obj", "bunny.obj",
        "spot", "office_chair", "greek_helmet", "casting", "homer", "fandisk", "gears", "rocker_arm", "mountain",
        "bunny", "nefertiti", "dragon_raw", "igea",
    ],
)  # fmt: skip
def test_equals_pygeodesic(name, tmp_path):
    mesh = real_mesh(name)
    try:
        reference = pygeodesic_field(mesh, SOURCE, tmp_path, SECONDS_FOR_LARGE if name in LARGE else 240)
    except PygeodesicFailedError as why:
        if name in NON_MANIFOLD_EDGES or name in LARGE:
            pytest.skip(f"pygeodesic {why} on {name}")
        raise
    assert_equal_fields(vorogeo.exact_distance_field(*mesh, SOURCE), reference)


@pytest.mark.parametrize("name", ["basket", "abc3", "city_lod1", "fsaverage5"])
def test_equals_pygeodesic_or_a_path_proves_a_shorter_distance(name, tmp_path):
    vertices, faces = real_mesh(name)
    try:
        reference = pygeodesic_field((vertices, faces), SOURCE, tmp_path, SECONDS_FOR_NEEDLES)
    except PygeodesicFailedError as why:
        pytest.skip(f"pygeodesic {why} on {name}")
    field = vorogeo.exact_distance_field(vertices, faces, SOURCE)
    np.testing.assert_array_equal(np.isinf(field), np.isinf(reference))
    assert (field <= reference * (1 + 1e-9)).all()
    shorter = np.flatnonzero(field < reference * (1 - 1e-9))
    if len(shorter) == 0:
        return
    # pygeodesic errs on needles and non-manifold edges: a line over the surface with our length is the proof.
    worst = shorter[np.argsort(field[shorter] / reference[shorter])[:PROVED]]
    index = vorogeo.GeodesicIndex(vertices, faces)
    for target, path in zip(worst, index.exact_path(np.full(len(worst), SOURCE), worst), strict=True):
        check_path(vertices, faces, path)
        assert path.length == pytest.approx(field[target], rel=1e-9)


@pytest.mark.parametrize("name", NON_MANIFOLD_VERTEX)
def test_is_at_most_pygeodesic_where_fans_meet_and_equal_once_they_are_split(name, tmp_path):
    vertices, faces = real_mesh(name)
    field = vorogeo.exact_distance_field(vertices, faces, SOURCE)
    reference = pygeodesic_field((vertices, faces), SOURCE, tmp_path, 240)
    assert (field <= reference * (1 + 1e-12)).all()

    vertex = NON_MANIFOLD_VERTEX[name]
    split = split_at(vertices, faces, vertex)
    split_field = vorogeo.exact_distance_field(*split, SOURCE)
    assert_equal_fields(split_field, pygeodesic_field(split, SOURCE, tmp_path, 240))

    # Whatever is shorter than on the split mesh is so because its path passes through the vertex.
    shorter = field < split_field[:-1] * (1 - 1e-9)
    assert shorter.any()
    through = field[vertex] + vorogeo.exact_distance_field(vertices, faces, vertex)
    np.testing.assert_allclose(field[shorter], through[shorter], rtol=1e-9)


def split_at(vertices: NDArray[np.float64], faces: NDArray[np.int32], vertex: int) -> Mesh:
    """The mesh with a copy of the vertex, at its end, for one of the two fans of faces around it."""
    around = np.flatnonzero((faces == vertex).any(axis=1))
    fan = {int(around[0])}
    for _ in around:
        rim = set(faces[list(fan)].ravel().tolist()) - {vertex}
        fan |= {int(face) for face in around if rim & set(faces[face].tolist())}
    assert len(fan) < len(around)
    split = faces.copy()
    split[list(fan)] = np.where(faces[list(fan)] == vertex, len(vertices), faces[list(fan)])
    return np.vstack([vertices, vertices[vertex]]), split
