"""Reads triangle meshes from files: whatever nibabel, meshio or PyMeshLab reads."""

from __future__ import annotations

import contextlib
import importlib
import importlib.util
import io
import os
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _arguments as check
from .errors import FileError, InvalidInput
from .mesh_objects import of_meshio
from .results import MeshArrays

#: Endings of FreeSurfer's surface files.
FREESURFER = (".white", ".pial", ".inflated", ".sphere", ".orig", ".smoothwm", ".midthickness", ".reg")


# Names in PLY files of the columns that meshio reads into one array.
_COLUMNS = {"obj:vn": ("nx", "ny", "nz"), "obj:vt": ("s", "t")}


def read_mesh(file: str | os.PathLike[str]) -> MeshArrays:
    """Read a mesh; vertices keep the order of the file, and polygons become fans of triangles.

    Parameters
    ----------
    file : str or path
        GIFTI (.gii, .gii.gz) and FreeSurfer surfaces (lh.white, rh.pial, ...) need nibabel; other formats meshio or
        PyMeshLab, whichever reads it first.

    Returns
    -------
    MeshArrays
        `vertices` and `faces`, as a tuple of these two.

    Raises
    ------
    FileError
        (an OSError) If the file is missing, or cannot be read by any of these; says why, and what to install.
    InvalidInput
        (a ValueError) If it holds no triangle.
    """
    return read_with_values(file)[0]


def read_with_values(file: str | os.PathLike[str]) -> tuple[MeshArrays, dict[str, NDArray[Any]]]:
    """The mesh, and the file's other values of vertices: colours, normals, texture coordinates, numbers.

    These are named as in PLY files. There are none if meshio cannot read the file or is not installed.
    """
    path = check.file_path(file)
    if not os.path.isfile(path):
        raise FileError(f"{path}: {'is a folder' if os.path.isdir(path) else 'there is no such file'}.")
    reasons = []
    for name, package, reader in _readers(Path(path)):
        if importlib.util.find_spec(package) is None:
            reasons.append(f"{name} is not installed (pip install {package})")
            continue
        try:
            vertices, faces, *values = reader(path)
        except MemoryError:
            raise
        except (Exception, SystemExit) as error:  # meshio ends the process for a file that it does not understand
            reasons.append(f"{name}: {' '.join(str(error).split()) or type(error).__name__}")
            continue
        if not len(faces):
            raise InvalidInput(f"{path}: holds no triangle; give a surface.")
        points = check.vertices(vertices)
        return MeshArrays(points, check.faces(faces, len(points))), values[0] if values else {}
    raise FileError(f"{path}: cannot be read as a mesh ({'; '.join(reasons)}).")


def _readers(path: Path) -> Iterator[tuple[str, str, Callable[[str], tuple[Any, ...]]]]:
    name = path.name.lower().removesuffix(".gz")
    if name.endswith(".gii"):
        yield "nibabel", "nibabel", _read_gifti
    elif name.startswith(("lh.", "rh.")) or name.endswith(FREESURFER):
        yield "nibabel", "nibabel", _read_freesurfer
    else:
        yield "meshio", "meshio", _read_with_meshio
        yield "PyMeshLab", "pymeshlab", _read_with_pymeshlab


def _read_gifti(path: str) -> tuple[Any, Any]:
    import nibabel

    image = nibabel.load(path)
    arrays = [image.get_arrays_from_intent(f"NIFTI_INTENT_{kind}") for kind in ("POINTSET", "TRIANGLE")]
    if not all(arrays):
        raise ValueError("holds no surface, only values")
    return arrays[0][0].data, np.asarray(arrays[1][0].data, np.int32)


def _read_freesurfer(path: str) -> tuple[Any, Any]:
    import nibabel.freesurfer

    vertices, faces = nibabel.freesurfer.read_geometry(path)[:2]
    return vertices, np.asarray(faces, np.int32)


def _read_with_meshio(path: str) -> tuple[Any, Any, dict[str, NDArray[Any]]]:
    import meshio

    if path.lower().endswith(".off") and not _has_second_line(path):  # meshio would wait for it forever
        raise ValueError("ends before the numbers of vertices and faces")
    with contextlib.redirect_stdout(io.StringIO()), contextlib.redirect_stderr(io.StringIO()):
        mesh = meshio.read(path)
    found: dict[str, NDArray[Any]] = {}
    for name, values in mesh.point_data.items():
        columns = _COLUMNS.get(name, (name,))
        table = np.reshape(values, (len(mesh.points), -1))
        if table.dtype == np.int8:  # what meshio makes of "uchar", so of colours
            table = table.view(np.uint8)
        if table.shape[1] == len(columns) and table.dtype.kind in "iuf":
            found |= dict(zip(columns, table.T, strict=True))
    return *of_meshio(mesh), found


def _has_second_line(path: str) -> bool:
    """Whether anything but comments follows the first line."""
    with open(path, "rb") as file:
        next(file, None)
        return any(line.strip() and not line.strip().startswith(b"#") for line in file)


def _read_with_pymeshlab(path: str) -> tuple[Any, Any]:
    pymeshlab: Any = importlib.import_module("pymeshlab")
    mesh_set = pymeshlab.MeshSet()
    mesh_set.load_new_mesh(path)
    mesh = mesh_set.current_mesh()
    return np.array(mesh.vertex_matrix()), np.array(mesh.face_matrix(), np.int32)
