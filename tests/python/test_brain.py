"""Labels and masks from brain files; distances to borders and nearest labels, on the plane where they have formulas."""

import numpy as np
import pytest
import vorogeo
from vorogeo import brain

from sample_meshes import plane_grid, write_off

nibabel = pytest.importorskip("nibabel")

VERTICES, FACES = plane_grid(21, 17, 2.0, 1.6)
X, Y = VERTICES[:, 0], VERTICES[:, 1]
HALVES = np.where(X < 1.05, 1, 2)  # the border runs at x = 1.05, half way between two columns
WALL = Y > 1.25
COLOURS = np.arange(20).reshape(4, 5)
NAMES = [b"Unknown", b"V1", b"Medial_wall", b"V2"]


@pytest.fixture(scope="module")
def index():
    return vorogeo.GeodesicIndex(VERTICES, FACES, patches=(4, 3))


def gifti(values, intent, table=None):
    image = nibabel.gifti.GiftiImage()
    if table:
        image.labeltable.labels = []
        for key, name in table.items():
            label = nibabel.gifti.GiftiLabel(key)
            label.label = name
            image.labeltable.labels.append(label)
    image.add_gifti_data_array(nibabel.gifti.GiftiDataArray(values, intent=f"NIFTI_INTENT_{intent}"))
    return image


@pytest.fixture
def files(tmp_path):
    labels = np.where(WALL, 2, np.where(X < 1.05, 1, 3))
    nibabel.freesurfer.write_annot(
        tmp_path / "lh.parts.annot", labels, np.arange(20).reshape(4, 5), NAMES, fill_ctab=True
    )
    table = {0: "???", 1: "V1", 2: "Medial wall", 3: "V2"}
    gifti(labels.astype(np.int32), "LABEL", table).to_filename(tmp_path / "parts.label.gii")
    gifti((~WALL).astype(np.float32), "SHAPE").to_filename(tmp_path / "roi.shape.gii")
    np.save(tmp_path / "roi.npy", ~WALL)
    rows = [f"{v} {VERTICES[v, 0]} {VERTICES[v, 1]} 0 0" for v in np.flatnonzero(~WALL)]
    (tmp_path / "lh.cortex.label").write_text("\n".join(["#!ascii label", str(len(rows)), *rows]) + "\n")
    return tmp_path


def test_labels_of_annotations_and_gifti(files):
    expected = np.where(WALL, 2, np.where(X < 1.05, 1, 3))
    for name in ("lh.parts.annot", "parts.label.gii"):
        labels = brain.read_labels(files / name)
        np.testing.assert_array_equal(labels.values, expected)
        assert labels.names[1] == "V1"
        np.testing.assert_array_equal(labels.mask(), ~WALL)
        np.testing.assert_array_equal(labels.mask(outside=["v1"]), expected != 1)


@pytest.mark.parametrize("name", ["lh.parts.annot", "parts.label.gii", "roi.shape.gii", "roi.npy", "lh.cortex.label"])
def test_masks_of_every_kind_of_file(files, name):
    np.testing.assert_array_equal(brain.read_mask(files / name, len(VERTICES)), ~WALL)


def test_the_command_line_takes_masks(files):
    from vorogeo.cli.main import main

    write_off(files / "m.off", VERTICES, FACES)
    arguments = ["field", str(files / "m.off"), "--from", "0", "--mask", str(files / "lh.cortex.label"), "--exact"]
    assert main([*arguments, "--out", str(files / "f.npy"), "--quiet"]) == 0
    field = np.load(files / "f.npy")
    assert np.isinf(field[WALL]).all()
    np.testing.assert_allclose(field[~WALL], np.hypot(X, Y)[~WALL], atol=1e-12)


def test_distance_from_a_straight_border(index):
    points = brain.label_borders(index, HALVES).positions(VERTICES, FACES)
    np.testing.assert_allclose(points[:, 0], 1.05)
    np.testing.assert_allclose([points[:, 1].min(), points[:, 1].max()], [0, 1.6])
    gaps = np.diff(np.unique(points[:, 1].round(9)))
    assert gaps.max() <= 0.25 * np.hypot(0.1, 0.1)
    for method, of_the_index in (("exact", 0), (None, 0.01)):
        found = brain.border_distance(index, HALVES, method=method)
        np.testing.assert_allclose(found, np.abs(X - 1.05), rtol=of_the_index, atol=2e-3)
    assert np.isinf(brain.border_distance(index, np.ones(len(X), int))).all()
    near = brain.border_distance(index, HALVES, max_distance=0.3, method="exact")
    np.testing.assert_array_equal(np.isfinite(near), np.abs(X - 1.05) < 0.3)


def test_borders_of_one_label_and_where_three_meet(index):
    three = np.where(Y > 0.85, 3, HALVES)
    found = brain.border_distance(index, three, label=3, method="exact")
    np.testing.assert_allclose(found, np.abs(Y - 0.85), atol=2e-3)
    points = brain.label_borders(index, three)
    where = points.positions(VERTICES, FACES)
    on_a_border = (np.abs(where[:, 0] - 1.05) < 0.06) | (np.abs(where[:, 1] - 0.85) < 0.06)
    assert on_a_border.all()
    np.testing.assert_allclose(points.barycentric.sum(axis=1), 1)


def test_the_mask_has_no_borders():
    index = vorogeo.GeodesicIndex(VERTICES, FACES, mask=~WALL)
    labels = np.where(WALL, 7, HALVES)
    where = brain.label_borders(index, labels).positions(VERTICES, FACES)
    np.testing.assert_allclose(where[:, 0], 1.05)
    assert where[:, 1].max() <= 1.25


def test_nearest_labels_are_the_voronoi_regions_of_sets(index):
    seeds = np.zeros(len(X), int)
    seeds[X < 0.15], seeds[X > 1.65] = 4, 9
    for answerer in (index, vorogeo.Surface(VERTICES, FACES)):
        label, distance = brain.nearest_label(answerer, seeds)
        expected = np.minimum(np.maximum(X - 0.1, 0), np.maximum(1.7 - X, 0))
        np.testing.assert_allclose(distance, expected, atol=5e-3)
        clear = np.abs(X - 0.9) > 0.01
        np.testing.assert_array_equal(label[clear], np.where(X < 0.9, 4, 9)[clear])
    limited, _ = brain.nearest_label(index, seeds, max_distance=0.25)
    np.testing.assert_array_equal(limited == -1, np.abs(X - 0.9) < 0.52)


def test_neighbours_within_a_radius_are_sparse(index):
    masked = vorogeo.GeodesicIndex(VERTICES, FACES, mask=~WALL)
    near = masked.pairs_within(np.arange(len(X)), 0.25, method="exact").toarray()
    apart = np.linalg.norm(VERTICES[:, None] - VERTICES[None], axis=2)
    expected = (apart <= 0.25) & (apart > 0) & ~WALL[:, None] & ~WALL[None]
    np.testing.assert_array_equal(near > 0, expected)


@pytest.mark.parametrize(
    ("call", "error", "message"),
    [
        (lambda folder: brain.read_labels(folder / "lh.cortex.label"), vorogeo.InvalidInput, "give vertex_count"),
        (lambda folder: brain.read_labels(folder / "none.annot"), vorogeo.FileError, r"none\.annot: cannot be read"),
        (lambda folder: brain.read_mask(folder / "none.gii"), vorogeo.FileError, r"none\.gii: cannot be read"),
    ],
)
def test_errors_of_files(files, call, error, message):
    with pytest.raises(error, match=message):
        call(files)


def test_errors_of_labels(index):
    with pytest.raises(vorogeo.InvalidInput, match=r"labels: have shape \(3,\)"):
        brain.border_distance(index, [1, 2, 3])
    with pytest.raises(vorogeo.InvalidInput, match="no vertex has a label"):
        brain.nearest_label(index, np.zeros(len(X), int))
    with pytest.raises(vorogeo.InvalidInput, match="label: no vertex has 9"):
        brain.border_distance(index, HALVES, label=9)
    with pytest.raises(vorogeo.InvalidInput, match="outside: no label is called 'wal'"):
        brain.Labels(HALVES, {1: "left", 2: "wall"}).mask(outside=["wal"])


def test_a_background_may_be_one_number(index):
    for found, same in zip(*(brain.nearest_label(index, HALVES, background=one) for one in (1, [1])), strict=True):
        np.testing.assert_array_equal(found, same)
