"""Fields on meshes that Python packages carry, so that every clone has them: exact distances and docs/figures.md."""

from pathlib import Path

import numpy as np
import pytest
import vorogeo

from sample_meshes import Mesh


def of_pyvista(name: str) -> Mesh:
    """One of the models in the package pyvista."""
    pyvista = pytest.importorskip("pyvista")
    mesh = pyvista.read(Path(pytest.importorskip("pyvista.examples").__file__).parent / name)
    return np.array(mesh.points, dtype=float), mesh.faces.reshape(-1, 4)[:, 1:].astype(np.int32)


def back_of_a_cortex() -> Mesh:
    """The part of the left hemisphere that lies behind y = -45 mm, on the pial surface in the package nilearn."""
    folder = Path(pytest.importorskip("nilearn").__file__).parent / "datasets" / "data" / "fsaverage5"
    vertices, faces = vorogeo.read_mesh(folder / "pial_left.gii.gz")
    faces = faces[(vertices[faces][:, :, 1] < -45).all(axis=1)]
    used, renumbered = np.unique(faces, return_inverse=True)
    return vertices[used], renumbered.reshape(faces.shape).astype(np.int32)


def errors_in_percent(mesh: Mesh, sources: int = 6) -> np.ndarray:
    """Sizes of the errors of fields from random sources; what no path reaches is infinite in both."""
    index = vorogeo.GeodesicIndex(*mesh)
    errors = []
    for source in np.random.default_rng(1).integers(0, len(mesh[0]), sources):
        exact = vorogeo.exact_distance_field(*mesh, source)
        found = index.distance_field(source)
        np.testing.assert_array_equal(np.isinf(found), np.isinf(exact))
        compared = (exact > 0) & np.isfinite(exact)
        errors.append(100 * np.abs(found[compared] / exact[compared] - 1))
    return np.concatenate(errors)


def test_fields_of_one_patch_are_exact():
    assert errors_in_percent(of_pyvista("ant.ply")).max(initial=0.0) <= 1e-7


def test_a_nut_has_few_patches():
    errors = errors_in_percent(of_pyvista("nut.ply"))
    assert errors.mean() <= 2 * 0.0022
    assert errors.max() <= 2 * 0.15


def test_thin_parts_of_an_airplane():
    errors = errors_in_percent(of_pyvista("airplane.ply"))
    assert errors.mean() <= 2 * 0.0011
    assert errors.max() <= 2 * 0.04


def test_folds_of_a_cortex():
    errors = errors_in_percent(back_of_a_cortex())
    assert errors.mean() <= 2 * 0.0084
    assert np.quantile(errors, 0.99) <= 2 * 0.052
    assert errors.max() <= 2 * 0.16
