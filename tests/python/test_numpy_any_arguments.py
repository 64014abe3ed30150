"""Whatever a method of Surface is asked with is answered, or refused in a sentence; the mesh stays as it was."""

import math

import numpy as np
import pytest
import vorogeo
from hypothesis import given, settings
from hypothesis import strategies as st

from sample_meshes import plane_grid, prism, side_by_side

# A tube of four rings of six vertices, a plane, and an isolated vertex.
VERTICES, FACES = side_by_side(prism(6, 4, 2.0), plane_grid(3, 3))
VERTICES = np.vstack([VERTICES, [[9.0, 9.0, 9.0]]])
COUNT = len(VERTICES)
NOWHERE = vorogeo.SurfacePoints(np.array([10**6]), np.array([[0.2, 0.3, 0.5]]))
ODD = [math.nan, math.inf, -math.inf, -1.0, 0.0, 1e-300, 1e300, None, "far", True, [1.0, 2.0], 10**30]


def faces_and_weights(weights):
    return st.builds(
        lambda face, weight: vorogeo.SurfacePoints(np.array([face]), np.array([weight])),
        st.integers(0, len(FACES) - 1),
        weights,
    )


inside = st.sampled_from([(0.2, 0.3, 0.5), (1.0, 0.0, 0.0), (0.0, 0.5, 0.5)])
outside = st.sampled_from([(0.5, 0.5, 0.5), (-1.0, 1.0, 1.0), (math.nan, 0.5, 0.5)])
vertex = st.integers(0, 23) | st.integers(0, 23) | st.integers(0, COUNT - 1)
point = vertex | faces_and_weights(inside)
bad_point = (
    st.sampled_from([-1, COUNT, 2**40, 0.5, None, "0", math.nan, NOWHERE, [[0, 1]], True])
    | faces_and_weights(outside)
    | st.lists(point | st.sampled_from([-1, None]), max_size=3)
)
lines = [[0, 1, 7], [3, 9, 10, 16], [6, 7, 8, 9, 10, 11, 6], [13, 14, 20, 19, 13]]  # along edges, two of them closed
curve = (st.sampled_from(lines) | st.lists(vertex, min_size=2, max_size=5)).map(
    lambda ids: vorogeo.EdgeCurve(np.array(ids))
)


def mostly(good, bad):
    """Four times in five what can be answered: with several arguments, most calls have one bad at most."""
    return st.integers(0, 4).flatmap(lambda draw: bad if draw == 4 else good)


points = mostly(st.lists(point, min_size=1, max_size=6), bad_point)
one = mostly(point, bad_point)
sources = mostly(st.lists(point | curve, min_size=1, max_size=4), bad_point)
length = mostly(st.floats(0.01, 3.0), st.sampled_from(ODD))
count = mostly(st.integers(1, 8), st.sampled_from(ODD))
numbers = mostly(st.lists(st.floats(0, 3), min_size=1, max_size=6), st.sampled_from(ODD))
values = mostly(st.just(VERTICES[:, 0]), st.lists(st.floats(), max_size=COUNT + 1).map(np.array))
line = mostly(st.sampled_from(lines), points)
mask = mostly(st.just(np.arange(len(FACES)) < 20), numbers)
normal = mostly(st.sampled_from([(0.0, 0.0, 1.0), (1.0, 1.0, 0.0)]), numbers)
vectors = mostly(st.just([[1.0, 0.5]]), st.lists(st.lists(st.floats(), max_size=3), max_size=3))
way = st.sampled_from([None, "automatic", "exact", "index"]) | mostly(st.just("quick"), st.sampled_from(["best", 1]))
flag = st.booleans()
text = mostly(st.sampled_from(["distance", "linear", "end", "fields", "pairs", "automatic"]), st.sampled_from(ODD))

#: Of each method the arguments that must be given, then those that may be.
METHODS = {
    "area": ((), {"faces": mask, "vertices": points, "inside": line}),
    "b_spline": ((points,), {"closed": flag, "levels": count}),
    "band": ((sources, length), {"method": way}),
    "bezier": ((points,), {"samples": count}),
    "convex_hull": ((points,), {"method": way}),
    "cut": ((line,), {}),
    "cut_at_levels": ((values, numbers), {"interpolation": text}),
    "cut_locus": ((points,), {"min_angle": length, "max_distance": length}),
    "disk": ((sources, length), {"method": way}),
    "disk_area": ((sources, length), {"method": way}),
    "distance": ((points, one), {"method": way}),
    "distance_field": ((sources,), {"max_distance": length, "offsets": numbers, "return_labels": flag, "method": way}),
    "distance_gradient": ((one, points), {}),
    "distance_matrix": ((points,), {"others": points, "entries": text, "method": way}),
    "distances": ((points, points), {"method": way}),
    "eccentricity": ((points,), {"method": way}),
    "exact_path": ((one, points), {"certify": flag, "method": way}),
    "exp_map": ((one, vectors), {"at_border": text}),
    "extent": ((), {"start": one, "fields": count, "method": way}),
    "fields": ((points,), {"max_distance": length, "method": way}),
    "frechet_mean": ((points,), {"weights": numbers}),
    "geometric_median": ((points,), {"weights": numbers}),
    "girth": ((one,), {"normal": normal}),
    "gradient": ((points,), {"points": points, "max_distance": length}),
    "isolines": ((values, numbers), {"interpolation": text}),
    "k_means": ((count,), {"points": points, "weights": numbers, "seed": count, "rounds": count}),
    "k_medoids": ((count,), {"points": points, "weights": numbers, "seed": count, "rounds": count}),
    "log_map": ((one,), {"targets": points, "max_distance": length}),
    "medoid": ((points,), {"weights": numbers, "method": way}),
    "nearest": ((points, points), {"k": count, "method": way}),
    "pairs_within": ((points, length), {"others": points, "as_arrays": flag, "method": way}),
    "pairs_within_bytes": ((points, length), {"others": points}),
    "path": ((points, one), {"method": way}),
    "path_through": ((points,), {"closed": flag, "method": way, "guides": flag}),
    "points_along": ((line, numbers), {}),
    "polygon": ((points,), {"method": way}),
    "profile": ((line,), {"up": normal}),
    "relax": ((points,), {"rounds": count, "method": way}),
    "sample_farthest": ((count,), {"radius": length, "start": points, "seed": count, "method": way}),
    "sample_poisson_disk": ((length,), {"seed": count, "method": way}),
    "set_distances": ((sources, sources), {"method": way}),
    "shortest_loop": ((one,), {"curve": line}),
    "signed_distance": ((line | st.just(np.arange(len(FACES)) < 20),), {"max_distance": length}),
    "snap": ((vectors,), {"max_distance": length}),
    "spline": ((points,), {"closed": flag, "samples": count}),
    "tangent_frames": ((points,), {}),
    "texture_coordinates": ((one, length), {"rotation": length, "scale": length}),
    "tighten": ((line,), {}),
    "transport": ((line, vectors), {}),
    "transport_from": ((one, vectors | st.just((1.0, 0.5))), {"max_distance": length}),
    "voronoi": ((points,), {"method": way}),
}


@st.composite
def calls(draw):
    name = draw(st.sampled_from(sorted(METHODS)))
    needed, optional = METHODS[name]
    chosen = [key for key in optional if draw(st.booleans())]
    return name, [draw(argument) for argument in needed], {key: draw(optional[key]) for key in chosen}


@pytest.fixture(scope="module")
def surfaces():
    return vorogeo.Surface(VERTICES, FACES), vorogeo.GeodesicIndex(VERTICES, FACES, patches=(2, 2))


def test_every_method_that_asks_is_here():
    others = {"build_index", "of", "prepare_exact_paths", "to_pyvista"}
    public = {name for name in dir(vorogeo.Surface) if not name.startswith("_")}
    assert {name for name in public if callable(getattr(vorogeo.Surface, name))} - others == set(METHODS)


@settings(max_examples=600, deadline=None)
@given(call=calls(), has_index=st.booleans())
def test_any_call_is_answered_or_refused_in_a_sentence(surfaces, call, has_index):
    surface = surfaces[has_index]
    name, given_arguments, options = call
    try:
        getattr(surface, name)(*given_arguments, **options)
    except vorogeo.Error as error:
        sentence = str(error)
        assert len(sentence) > 20, sentence
        assert sentence.endswith((".", ")")), sentence
    np.testing.assert_array_equal(surface.vertices, VERTICES)
    np.testing.assert_array_equal(surface.faces, FACES)
