"""Masks: distances go around what is masked, and results refer to the mesh as it was given."""

import pickle

import numpy as np
import pytest
import vorogeo

from sample_meshes import plane_grid

VERTICES, FACES = plane_grid(21, 21)
X, Y = VERTICES[:, 0], VERTICES[:, 1]
WALL = (np.abs(X - 0.5) < 0.09) & (Y < 0.79)  # a bar from the lower side, vertices
KEPT = ~WALL


@pytest.fixture(scope="module")
def index():
    return vorogeo.GeodesicIndex(VERTICES, FACES, patches=(4, 3), mask=KEPT)


def test_a_mask_of_vertices_is_that_of_their_faces(index):
    faces_kept = KEPT[FACES].all(axis=1)
    np.testing.assert_array_equal(index.mask, faces_kept)
    other = vorogeo.GeodesicIndex(VERTICES, FACES, patches=(4, 3), mask=faces_kept.astype(int))
    np.testing.assert_array_equal(other.distance_field(0), index.distance_field(0))
    assert vorogeo.GeodesicIndex(VERTICES, FACES).mask is None


def test_face_results_refer_to_all_faces(index):
    gone = ~index.mask
    regions = index.voronoi([0, 440])
    assert len(regions.face_region) == len(index.face_patches(1)) == len(FACES)
    assert (regions.face_region[gone] == -1).all()
    assert (regions.face_region[~gone] >= 0).all()
    assert (index.face_patches(1)[gone] == -1).all()
    assert regions.area.sum() == pytest.approx(index.mask.sum() * 0.05**2 / 2)
    disk = index.disk(0, 0.45)
    assert index.mask[disk.faces].all()
    centre = FACES[disk.faces].ravel()
    assert (np.hypot(X[centre], Y[centre]) <= 0.45 * 1.01).all()


def test_points_are_moved_to_what_is_left(index):
    snapped = index.snap([0.5, 0.2, 0.0])
    assert index.mask[snapped.faces].all()
    assert snapped.snap_distance[0] == pytest.approx(0.1)
    masked = vorogeo.SurfacePoints(np.flatnonzero(~index.mask)[:1], np.full((1, 3), 1 / 3))
    with pytest.raises(vorogeo.InvalidInput, match="it is masked"):
        index.distance_field(masked)


def test_samples_and_neighbours_leave_the_mask_out(index):
    used = np.unique(FACES[index.mask])
    assert np.isin(index.sample_farthest(30).vertices, used).all()
    assert np.isin(index.sample_poisson_disk(0.2), used).all()
    assert np.isfinite(index.sample_farthest(30).covering_radius)
    near = index.pairs_within(np.arange(441), 0.12, as_arrays=True)
    rows = np.repeat(np.arange(441), np.diff(near.indptr))
    assert np.isin(rows, used).all()
    assert np.isin(near.indices, used).all()


def test_a_mask_is_kept_by_pickle_and_needed_to_load(index, tmp_path):
    other = pickle.loads(pickle.dumps(index))
    np.testing.assert_array_equal(other.mask, index.mask)
    index.save(tmp_path / "m.vgi")
    again = vorogeo.GeodesicIndex.load(tmp_path / "m.vgi", VERTICES, FACES, mask=KEPT)
    for one in (other, again):
        np.testing.assert_array_equal(one.distance_field(3), index.distance_field(3))
    with pytest.raises(vorogeo.IndexFileError):
        vorogeo.GeodesicIndex.load(tmp_path / "m.vgi", VERTICES, FACES)


@pytest.mark.parametrize(
    ("mask", "message"),
    [
        (np.ones(7), r"mask: has shape \(7,\); give one value for each of the 800 faces or 441 vertices"),
        (np.arange(441), r"mask\[2\]: is .*2.*, neither False nor True"),
        (["a"] * 441, r"mask\[0\]: is"),
        (np.zeros(800, bool), "no face"),
    ],
)
def test_bad_masks_are_refused(mask, message):
    with pytest.raises(vorogeo.InvalidInput, match=message):
        vorogeo.GeodesicIndex(VERTICES, FACES, mask=mask)
