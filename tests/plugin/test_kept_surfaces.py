"""A layer is read once: later calls answer from the surface that was kept, and never from one that is out of date."""

from __future__ import annotations

import itertools
import time

import filters
import numpy as np
import pymeshlab
import pytest
from support import (
    arrays,
    assert_close_to_exact,
    exact_distances,
    field,
    grid,
    length,
    logged,
    mesh_set,
    select_vertices,
    sphere,
)

_sizes = itertools.count(1)


def new_sphere() -> tuple[np.ndarray, np.ndarray]:
    """A sphere of a size of its own: the plugin keeps indexes between tests."""
    vertices, faces = sphere(3)
    return vertices * (1 + next(_sizes) / 16), faces


def fields_of_now(ms: pymeshlab.MeshSet, reused: bool) -> np.ndarray:
    """An exact field and one from the index, right for the mesh as it is now; the index was reused or not as stated."""
    exact = exact_distances(*arrays(ms), [0])
    ms.apply_filter(filters.EXACT_FROM_POINT, vertex_index=0)
    np.testing.assert_allclose(field(ms), exact, rtol=1e-9, atol=1e-12)
    found = [field(ms).copy()]
    assert ms.apply_filter(filters.FROM_POINT, vertex_index=0, method="index")["index_reused"] == reused
    assert_close_to_exact(field(ms), exact, mean=0.0004, largest=0.01)
    return np.array([*found, field(ms)])


def remove_vertices(ms: pymeshlab.MeshSet) -> None:
    select_vertices(ms, [200, 201])
    ms.apply_filter("meshing_remove_selected_vertices")


def remove_faces(ms: pymeshlab.MeshSet) -> None:
    ms.apply_filter("compute_selection_by_condition_per_face", condselect="(z0 < -0.8) && (x0 > 0)")
    ms.apply_filter("meshing_remove_selected_faces")
    ms.apply_filter("meshing_remove_unreferenced_vertices")


EDITS = {
    "stretching": lambda ms: ms.apply_filter(
        "compute_matrix_from_scaling_or_normalization", axisx=2.5, uniformflag=False
    ),
    "moving a vertex": lambda ms: ms.apply_filter(
        "compute_coord_by_function", x="(vi == 100) ? x * 1.000001 : x", y="y", z="z"
    ),
    "subdividing": lambda ms: ms.apply_filter("meshing_surface_subdivision_midpoint", iterations=1),
    "turning faces": lambda ms: ms.apply_filter("meshing_invert_face_orientation"),
    "removing vertices": remove_vertices,
    "removing faces": remove_faces,
}


@pytest.mark.parametrize("edit", EDITS)
def test_an_edit_is_seen_and_undoing_it_gives_the_old_answers_to_the_last_bit(edit):
    vertices, faces = new_sphere()
    ms = mesh_set(vertices, faces)
    before = fields_of_now(ms, reused=False)
    ms.apply_filter("compute_normal_per_vertex")
    select_vertices(ms, [1])
    ms.apply_filter(filters.PATCHES)
    np.testing.assert_array_equal(fields_of_now(ms, reused=True), before)  # colours and selection are no edit
    EDITS[edit](ms)
    fields_of_now(ms, reused=False)
    np.testing.assert_array_equal(fields_of_now(mesh_set(vertices, faces), reused=True), before)


def test_index_of_the_build_filter_is_used_and_replaced():
    ms = mesh_set(*new_sphere())
    for patches in (6, 9):
        ms.apply_filter(filters.INDEX, n1=patches)
        result = ms.apply_filter(filters.PATCHES)
        assert (result["patches"], result["index_reused"]) == (patches, True)


def test_start_points_of_later_calls_are_found_on_the_mesh_of_now():
    vertices, faces = grid(6, 6)
    ms = mesh_set(vertices, faces)
    for height in (0.0, 0.5):
        for _ in range(2):
            result = ms.apply_filter(filters.EXACT_FROM_POINT, start_point=[2.3, 3.1, 0.25])
            assert result["snap_distance"] == pytest.approx(0.25, abs=1e-6)
            assert result["start_face"] >= 0
        ms.apply_filter("compute_coord_by_function", x="x", y="y", z=str(0.5 - height))


def test_warnings_and_remarks_on_the_metric_are_logged_at_every_call():
    setup = "v, f = grid(4, 4)\nms.add_mesh(pymeshlab.Mesh(v, np.vstack([f, f[:1]])))"
    calls = [
        "ms.apply_filter(EXACT_FROM_POINT, vertex_index=0)",
        "ms.apply_filter(EXACT_FROM_POINT, vertex_index=1)",
        "ms.apply_filter(TWO_POINTS, source=0, target=1, method='exact')",
        "ms.apply_filter(EXTENT, exact=True)",
    ]
    for call, seen in zip(calls, logged(setup, calls), strict=True):
        assert seen.count("Mesh: 1 face has the three vertices of an earlier face") == 1, call
    call = (
        "ms.apply_filter('compute_scalar_by_function_per_vertex', q='(vi == 24) ? 1000 : 1');"
        "ms.apply_filter(EXACT_FROM_POINT, vertex_index=0, metric='Vertex quality as cost')"
    )
    for seen in logged("ms.add_mesh(pymeshlab.Mesh(*grid(6, 6)))", [call, call]):
        assert seen.count("faces are measured in parts") == 1


def test_later_calls_pay_for_the_answer_only():
    """On a sphere of 40,962 vertices reading, checking and laying out the mesh takes most of a first call."""
    ms = mesh_set(*sphere(6))

    def seconds(source: int) -> float:
        start = time.process_time()
        ms.apply_filter(filters.EXACT_FROM_POINT, vertex_index=source, max_distance=length(0.02))
        return time.process_time() - start

    first = seconds(0)
    assert min(seconds(source) for source in range(1, 8)) < 0.35 * first
