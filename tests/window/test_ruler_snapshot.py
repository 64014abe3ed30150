"""What MeshLab's snapshots hold of a measurement, on displays of both densities: its line and its label."""

from __future__ import annotations

import numpy as np
import pytest
from PIL import Image
from results import FOLDER, written_down

SCRIPTS = ("ruler_snapshot", "ruler_density")


@pytest.fixture(scope="module", params=[(script, times) for script in SCRIPTS for times in (1, 2)])
def snapshot(request: pytest.FixtureRequest) -> np.ndarray:
    """A picture, red, green and blue from 0 to 1."""
    script, times = request.param
    assert len(written_down(script)["rows"]) == 1
    return np.asarray(Image.open(FOLDER / script / f"snapshot{times - 1:02}.png"))[..., :3] / 255


def ends_of_line(picture: np.ndarray) -> list[tuple[int, int]]:
    """Column and row of both ends of what has the colour of measurements."""
    red, green, blue = np.moveaxis(picture, -1, 0)
    rows, columns = np.nonzero((red > 0.9) & (abs(green - 0.85) < 0.05) & (blue < 0.2))
    return [(columns[i], rows[i]) for i in (columns.argmin(), columns.argmax())]


def test_the_line_ends_where_the_mouse_was(snapshot):
    height, width = snapshot.shape[:2]
    places = written_down("ruler_snapshot")["ends"]
    for (column, row), place in zip(ends_of_line(snapshot), places, strict=True):
        assert (column - width / 2) / height == pytest.approx(place[0], abs=0.005)
        assert (height / 2 - row) / height == pytest.approx(place[1], abs=0.005)


def test_the_label_stands_beside_its_end(snapshot):
    column, row = ends_of_line(snapshot)[1]
    height = len(snapshot)
    beside = snapshot[row - height // 20 : row, column : column + height // 6]
    assert np.count_nonzero(beside.max(axis=-1) < 0.3) > 200  # its ground
    assert np.count_nonzero(beside.min(axis=-1) > 0.9) > 50  # its text


def test_a_denser_display_has_pictures_of_more_pixels():
    sizes = [Image.open(FOLDER / script / "snapshot00.png").size for script in SCRIPTS]
    assert sizes[1][0] == pytest.approx(2 * sizes[0][0], rel=0.02)
