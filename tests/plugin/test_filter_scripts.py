"""MeshLab filter scripts (.mlx) with filters of the plugin."""

from __future__ import annotations

import filters
import numpy as np
from support import exact_distances, field, length, mesh_set, sphere


def test_saved_script_runs_again(tmp_path):
    vertices, faces = sphere(3)
    script = tmp_path / "script.mlx"
    first = mesh_set(vertices, faces)
    first.apply_filter(filters.INDEX, n1=6, seed=2)
    first.apply_filter(filters.PATCHES, layer=1)
    first.apply_filter(filters.FROM_POINT, vertex_index=17, max_distance=length(1.5))
    first.save_filter_script(str(script))
    assert (
        filters.FROM_POINT in script.read_text()
        or "Geodesic distance from a given point (VoroGeo)" in script.read_text()
    )

    second = mesh_set(vertices, faces)
    second.load_filter_script(str(script))
    second.apply_filter_script()
    np.testing.assert_array_equal(field(second), field(first))
    np.testing.assert_array_equal(second.current_mesh().face_color_matrix(), first.current_mesh().face_color_matrix())
    exact = exact_distances(vertices, faces, [17])
    near = exact < 1.4
    np.testing.assert_allclose(field(second)[near], exact[near], rtol=0.02)
    np.testing.assert_array_equal(field(second)[exact > 1.6], -1)


def test_script_keeps_the_methods_of_a_comparison(tmp_path):
    script = tmp_path / "script.mlx"
    first = mesh_set(*sphere(2))
    first.apply_filter(filters.COMPARISON, vertex_index=3, method="Shortest edge path (Dijkstra)")
    first.save_filter_script(str(script))
    second = mesh_set(*sphere(2))
    second.load_filter_script(str(script))
    second.apply_filter_script()
    np.testing.assert_array_equal(field(second), field(first))
    assert field(second).max() > 0.01
