"""The guide runs as it is printed, and its results are those of the unrolled tube."""

import re
from pathlib import Path

import numpy as np
import pytest

from sample_meshes import prism_distances

PAGE = Path(__file__).resolve().parents[2] / "docs" / "guide.md"
SIDES, RINGS, HEIGHT = 24, 21, 4.0


def unrolled(source):
    return prism_distances(SIDES, RINGS, HEIGHT, source)


@pytest.fixture(scope="module")
def page(tmp_path_factory):
    """All names that the snippets define, run one after the other."""
    names = {}
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(tmp_path_factory.mktemp("guide"))
        for number, snippet in enumerate(re.findall(r"```python\n(.*?)```", PAGE.read_text(), flags=re.DOTALL)):
            exec(compile(snippet, f"snippet {number} of {PAGE.name}", "exec"), names)
        names["all.npy"] = np.load("all.npy")
    return names


def test_all_pairs_and_pairs(page):
    expected = np.array([unrolled(v) for v in range(SIDES * RINGS)])
    for matrix in (page["matrix"], page["all.npy"]):
        assert matrix.dtype == np.float32
        np.testing.assert_allclose(matrix, expected, rtol=0.02, atol=1e-6)
    pairs = [expected[k, 500 + k] for k in range(3)]
    np.testing.assert_allclose([page["one"], *page["many"]], [pairs[0], *pairs], rtol=0.01)
    np.testing.assert_allclose(page["certain"], pairs, rtol=1e-9)


def test_points_in_faces(page):
    assert page["near"].snap_distance[0] == pytest.approx(0.1)
    ends = page["near"].positions(page["vertices"], page["faces"])
    starts = np.vstack([page["middle"].positions(page["vertices"], page["faces"])[0], page["vertices"][17]])

    def flat(points):
        """Positions on the unrolled tube."""
        angle = np.arctan2(points[:, 1], points[:, 0]) % (2 * np.pi)
        side, rest = np.divmod(angle, 2 * np.pi / SIDES)
        step = np.pi / SIDES
        along = side * 2 * np.sin(step) + np.cos(step) * (np.tan(step) + np.tan(rest - step))
        return np.column_stack([along, points[:, 2]])

    apart = np.abs(flat(starts) - flat(ends))
    around = SIDES * 2 * np.sin(np.pi / SIDES)
    expected = np.hypot(np.minimum(apart[:, 0], around - apart[:, 0]), apart[:, 1])
    np.testing.assert_allclose(page["lengths"], expected, rtol=1e-3)


def test_paths(page):
    assert page["path"].certified
    assert page["path"].length == pytest.approx(unrolled(0)[500], rel=1e-9)
    np.testing.assert_allclose(page["again"], page["positions"], atol=1e-12)
    np.testing.assert_allclose(page["heights"], page["positions"][:, 2], atol=1e-12)


def test_coarse_meshes_unreachable_vertices_and_limits(page):
    corners = [0, 1, 1, np.sqrt(2), 1, np.sqrt(2), np.sqrt(2), np.sqrt(5)]
    np.testing.assert_allclose(page["exact"], corners, rtol=1e-12)
    np.testing.assert_allclose(page["coarse"], corners, rtol=1e-4)
    assert page["unreached"].sum() == 505
    assert (page["nowhere"].length, len(page["nowhere"].points)) == (np.inf, 0)
    sure = np.abs(unrolled(0) - 0.8) > 0.01
    np.testing.assert_array_equal(np.isfinite(page["near_field"])[sure], (unrolled(0) <= 0.8)[sure])
    np.testing.assert_array_equal(page["within"].vertices, np.flatnonzero(np.isfinite(page["near_field"])))
    expected = np.sort([unrolled(v) for v in (0, 100, 400)], axis=0)[:2].T
    np.testing.assert_allclose(page["closest"], expected, rtol=0.02, atol=1e-6)
    assert page["pairs"].max() <= 0.3


def test_edge_lengths_alone_measure_the_same(page):
    assert page["same_length"].length == pytest.approx(unrolled(0)[500], rel=1e-9)
    assert np.isnan(page["same_length"].points).all()
    positions = page["crossed"].positions(page["vertices"], page["faces"])
    steps = np.linalg.norm(np.diff(positions, axis=0), axis=1)
    assert steps.sum() == pytest.approx(page["same_length"].length, rel=1e-9)


def test_a_speed_that_grows_with_the_height_is_the_hyperbolic_plane(page):
    width = 2 * np.sin(np.pi / SIDES)
    step = np.arange(SIDES * RINGS) % SIDES
    aside = np.minimum(step, SIDES - step) * width
    above = 1 + page["vertices"][:, 2]
    expected = np.arccosh(1 + (aside**2 + (above - 1) ** 2) / (2 * above))
    np.testing.assert_allclose(page["seconds"], expected, rtol=0.01)
    assert page["quickest"].length == pytest.approx(expected[12], rel=0.01)
    # A circle around the middle of the path, at height 0 of that plane.
    assert page["quickest"].points[:, 2].max() == pytest.approx(np.hypot(6 * width, 1) - 1, abs=0.2)


def test_curves_masks_and_reuse(page):
    height = page["vertices"][:, 2]
    expected = np.minimum(height, unrolled(490) + 0.5)
    np.testing.assert_allclose(page["from_rim"], expected, rtol=0.02, atol=0.01)
    clear = np.abs(height - unrolled(490) - 0.5) > 0.05
    np.testing.assert_array_equal(page["source"][clear], (height > expected)[clear])
    assert page["round_about"] == pytest.approx(18 * 2 * np.sin(np.pi / SIDES), rel=0.01)
    assert page["regions"].area.sum() == pytest.approx(SIDES * 2 * np.sin(np.pi / SIDES) * HEIGHT)
    assert len(np.unique(page["lines"].values)) == 10
