"""Colours of patches: neighbours differ clearly, every face has the colour of its patch."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from support import INDEX, PATCHES, grid, mesh_set, sphere


def patches_by_color(faces: np.ndarray, colors: np.ndarray) -> np.ndarray:
    """Number of the connected set of equally coloured faces that each face lies in (faces meet at a vertex)."""
    corner_face = np.repeat(np.arange(len(faces)), 3)
    shares = coo_matrix((np.ones(faces.size), (corner_face, faces.ravel()))).tocsr()
    pairs = (shares @ shares.T).tocoo()
    same = np.all(colors[pairs.row] == colors[pairs.col], axis=1)
    graph = coo_matrix((np.ones(same.sum()), (pairs.row[same], pairs.col[same])), shape=(len(faces), len(faces)))
    return connected_components(graph, directed=False)[1]


@pytest.mark.parametrize("layer", [1, 2])
@pytest.mark.parametrize("mesh", [sphere(4), grid(50, 20)], ids=["sphere", "rectangle"])
def test_each_patch_is_one_connected_region_of_its_colour(mesh, layer):
    vertices, faces = mesh
    ms = mesh_set(vertices, faces)
    built = ms.apply_filter(INDEX, n1=15, n2=6)
    result = ms.apply_filter(PATCHES, layer=layer)
    assert result["patches"] == built["first_layer_patches" if layer == 1 else "second_layer_patches"]
    regions = patches_by_color(faces, ms.current_mesh().face_color_matrix())
    assert regions.max() + 1 == result["patches"]


@pytest.mark.parametrize("layer", [1, 2])
def test_colours_differ_clearly(layer):
    ms = mesh_set(*sphere(4))
    ms.apply_filter(INDEX, n1=20)
    result = ms.apply_filter(PATCHES, layer=layer)
    colors = np.unique(ms.current_mesh().face_color_matrix()[:, :3] * 255, axis=0)
    assert len(colors) == result["colors"] >= 4
    distances = np.linalg.norm(colors[:, None] - colors[None], axis=2)
    assert distances[~np.eye(len(colors), dtype=bool)].min() >= 60


def test_left_out_faces_are_grey():
    vertices, faces = grid(10, 10)
    faces = np.concatenate([faces, faces[:1]])
    ms = mesh_set(vertices, faces)
    ms.apply_filter(PATCHES)
    np.testing.assert_allclose(ms.current_mesh().face_color_matrix()[-1] * 255, [160, 160, 160, 255])


@pytest.mark.parametrize("layer", [1, 2])
def test_no_patch_looks_like_faces_that_are_in_none_or_not_reached(layer):
    ms = mesh_set(*sphere(5))
    ms.apply_filter(INDEX, n1=40)
    ms.apply_filter(PATCHES, layer=layer)
    colors = np.unique(ms.current_mesh().face_color_matrix()[:, :3] * 255, axis=0)
    assert len(colors) >= 8
    assert np.ptp(colors, axis=1).min() > 50  # no grey of any lightness


def test_only_face_colours_change():
    vertices, faces = sphere(3)
    ms = mesh_set(vertices, faces)
    ms.apply_filter(PATCHES)
    np.testing.assert_array_equal(ms.current_mesh().vertex_matrix(), vertices)
    np.testing.assert_array_equal(ms.current_mesh().face_matrix(), faces)
    np.testing.assert_array_equal(ms.current_mesh().vertex_scalar_array(), 0)
