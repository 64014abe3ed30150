"""Meshes from files: every reader gives the mesh that was written, and errors say what to do."""

import gzip

import numpy as np
import pytest
import vorogeo

from sample_meshes import bent_grid, packaged, write_off

VERTICES, FACES = bent_grid(9, 7)


def test_off_keeps_every_bit(tmp_path):
    write_off(tmp_path / "m.off", VERTICES, FACES)
    mesh = vertices, faces = vorogeo.read_mesh(tmp_path / "m.off")
    np.testing.assert_array_equal(vertices, VERTICES)
    np.testing.assert_array_equal(faces, FACES)
    assert (vertices.dtype, faces.dtype) == (np.float64, np.int32)
    assert mesh.vertices is vertices
    assert mesh.faces is faces


@pytest.mark.parametrize("ending", ["ply", "obj", "vtk", "stl"])
def test_formats_of_meshio(tmp_path, ending):
    meshio = pytest.importorskip("meshio")
    meshio.write_points_cells(tmp_path / f"m.{ending}", VERTICES.astype(np.float32), [("triangle", FACES)])
    vertices, faces = vorogeo.read_mesh(tmp_path / f"m.{ending}")
    assert len(faces) == len(FACES)
    np.testing.assert_allclose(vertices[faces], VERTICES[FACES], atol=1e-6)  # .stl has no vertices of its own


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("m.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nf 1 2 3 4\nf 2 5 3\n"),
        ("m.off", "OFF\n5 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n4 0 1 2 3\n3 1 4 2\n"),
    ],
)
def test_polygons_become_fans(tmp_path, name, text):
    if name == "m.off":
        pytest.importorskip("pymeshlab")  # meshio reads triangles only from this format
    (tmp_path / name).write_text(text)
    vertices, faces = vorogeo.read_mesh(tmp_path / name)
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    assert np.linalg.norm(np.cross(b - a, c - a), axis=1).sum() / 2 == pytest.approx(1.5)


def test_gifti_and_freesurfer(tmp_path):
    nibabel = pytest.importorskip("nibabel")
    arrays = [
        nibabel.gifti.GiftiDataArray(VERTICES.astype(np.float32), intent="NIFTI_INTENT_POINTSET"),
        nibabel.gifti.GiftiDataArray(FACES, intent="NIFTI_INTENT_TRIANGLE"),
    ]
    image = nibabel.gifti.GiftiImage(darrays=arrays)
    image.to_filename(tmp_path / "m.surf.gii")
    with gzip.open(tmp_path / "m.gii.gz", "wb") as out:
        out.write(image.to_bytes())
    nibabel.freesurfer.write_geometry(tmp_path / "lh.white", VERTICES, FACES)
    for name in ("m.surf.gii", "m.gii.gz", "lh.white"):
        vertices, faces = vorogeo.read_mesh(tmp_path / name)
        np.testing.assert_allclose(vertices, VERTICES, atol=1e-6)
        np.testing.assert_array_equal(faces, FACES)


def test_what_pymeshlab_brings():
    vertices, faces = packaged("cow.obj")
    import pymeshlab

    read = vorogeo.read_mesh(pymeshlab.__path__[0] + "/tests/sample_meshes/cow.obj")
    np.testing.assert_allclose(read[0], vertices, atol=1e-6)
    np.testing.assert_array_equal(read[1], faces)


def test_errors_name_the_file_and_what_to_do(tmp_path, monkeypatch):
    (tmp_path / "m.ply").write_text("nothing")
    with pytest.raises(vorogeo.FileError, match=r"m\.ply: cannot be read as a mesh \(meshio: .*PyMeshLab\b"):
        vorogeo.read_mesh(tmp_path / "m.ply")
    with pytest.raises(vorogeo.FileError, match="there is no such file"):
        vorogeo.read_mesh(tmp_path / "none.ply")
    (tmp_path / "m.off").write_text("OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n")
    with pytest.raises(vorogeo.Error, match=r"m\.off: "):
        vorogeo.read_mesh(tmp_path / "m.off")
    (tmp_path / "lh.pial").touch()
    monkeypatch.setattr("importlib.util.find_spec", lambda name: None)
    with pytest.raises(vorogeo.FileError, match="pip install nibabel"):
        vorogeo.read_mesh(tmp_path / "lh.pial")
