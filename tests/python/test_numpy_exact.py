"""vorogeo.exact_distance_field against formulas and against pygeodesic."""

import numpy as np
import vorogeo

from sample_meshes import cube, plane_grid, side_by_side


def test_result_belongs_to_the_caller():
    field = vorogeo.exact_distance_field(*cube(), 0)
    assert field.dtype == np.float64
    assert field.shape == (8,)
    assert field.flags.writeable
    field[:] = 1.0


def test_no_path_is_certified_beside_an_edge_too_long_for_digits():
    vertices, faces = plane_grid(14, 14, 1.0)
    vertices[100, 2] = 1e15
    for count in (5, 150):  # a corridor for each, one propagation for all
        targets = np.setdiff1d(np.arange(1, 160), [100])[:count]
        paths = vorogeo.exact_path(vertices, faces, np.zeros(count, int), targets)
        assert not any(path.certified for path in paths)


def test_a_path_to_another_component_has_no_points():
    vertices, faces = side_by_side(cube(), cube())
    none = vorogeo.exact_path(vertices, faces, 0, len(vertices) - 1)
    assert (none.length, len(none.points)) == (np.inf, 0)
