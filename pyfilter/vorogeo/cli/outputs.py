"""Writes results: arrays, tables, meshes with quality, GIFTI; each file appears whole or not at all."""

from __future__ import annotations

import math
import os
import tempfile
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import FileError, InvalidInput


@dataclass
class Result:
    """What a command found on one mesh."""

    main: str  # the array that formats for one array hold
    arrays: dict[str, NDArray[Any]]  # all of them
    mesh: tuple[NDArray[Any], NDArray[Any]]  # vertices, as in the file, and faces
    per_vertex: str = ""  # the one with a value for each vertex, for meshes with quality and GIFTI; empty: none
    per_face: str = ""  # the one with a value for each face, for meshes with quality of faces; empty: none
    no_value: float = -1  # what meshes with quality have where that is not finite, as the filters write it
    vertex_values: dict[str, NDArray[Any]] = field(default_factory=dict)  # what else a PLY has for each vertex
    lines: tuple[NDArray[Any], NDArray[Any]] | None = None  # points and edges to write as PLY instead of the mesh
    sparse: Any = None  # a scipy.sparse matrix instead of arrays
    text: str = ""  # what to tell the user
    summary: dict[str, Any] = field(default_factory=dict)  # and what to tell a program, with --json
    columns: list[str] = field(default_factory=list)


def plain(value: Any) -> Any:
    """What JSON can hold: lists instead of arrays and tuples, null for what is infinite or not a number."""
    if isinstance(value, (np.ndarray, np.generic)):
        value = value.tolist()
    if isinstance(value, dict):
        return {name: plain(one) for name, one in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(one) for one in value]
    return None if isinstance(value, float) and not math.isfinite(value) else value


@contextmanager
def whole_file(target: Path) -> Iterator[Path]:
    """A temporary name beside the target, with the same ending; it takes the target's place if the block succeeds."""
    try:
        descriptor, name = tempfile.mkstemp(suffix=f"-{target.name}", prefix=".vorogeo-", dir=target.parent)
    except OSError as error:
        raise FileError(f"{target}: cannot be written ({error.strerror}).") from None
    os.close(descriptor)
    part = Path(name)
    try:
        yield part
        umask = os.umask(0)
        os.umask(umask)
        part.chmod(0o666 & ~umask)
        os.replace(part, target)
    except OSError as error:
        raise FileError(f"{target}: cannot be written ({error.strerror or error}).") from None
    finally:
        part.unlink(missing_ok=True)


def write(result: Result, target: Path) -> None:
    """Write a result in the format that the file's name asks for; one that cannot hold it says which can."""
    writer = WRITERS.get(format_of(target))
    if writer is None:
        raise InvalidInput(f"{target}: has no known ending; give one of {', '.join(WRITERS)}.")
    with whole_file(target) as part:
        writer(result, part)


def format_of(target: Path) -> str:
    """The ending of a name, in lower case."""
    return target.suffix.lower()


def _main(result: Result) -> NDArray[Any]:
    if result.sparse is not None:
        raise InvalidInput("A sparse matrix goes into .npz, .mat or .csv; give one of these endings.")
    return result.arrays[result.main]


def _npy(result: Result, part: Path) -> None:
    np.save(part, _main(result), allow_pickle=False)


def _npz(result: Result, part: Path) -> None:
    if result.sparse is None:
        np.savez(part, allow_pickle=False, **result.arrays)
        return
    from scipy.sparse import csr_matrix, save_npz

    save_npz(part, csr_matrix(result.sparse), compressed=False)


def _mat(result: Result, part: Path) -> None:
    try:
        from scipy.io import savemat
    except ImportError:
        raise InvalidInput(".mat files are written by scipy; run 'pip install scipy', or choose .npz.") from None
    try:
        savemat(part, {result.main: result.sparse} if result.sparse is not None else result.arrays)
    except (ValueError, OverflowError) as error:
        raise InvalidInput(f"A .mat file cannot hold this result ({error}); choose .npy.") from None


def _csv(result: Result, part: Path) -> None:
    if result.sparse is not None:
        entries = result.sparse.tocoo()
        columns = [entries.row, entries.col, entries.data]
        names = ["row", "column", "distance"]
    else:
        table = _main(result)
        columns = [table] if table.ndim == 1 else list(table.T)
        names = result.columns or ([result.main] if table.ndim == 1 else [])
    with open(part, "w", encoding="ascii") as out:
        if names:
            out.write(",".join(names) + "\n")
        for row in zip(*(column.tolist() for column in columns), strict=True):
            out.write(",".join(map(repr, row)) + "\n")


_PLY_TYPES = {
    "i1": "char",
    "u1": "uchar",
    "i2": "short",
    "u2": "ushort",
    "i4": "int",
    "u4": "uint",
    "f4": "float",
    "f8": "double",
}


def _ply(result: Result, part: Path) -> None:
    points, cells = result.lines if result.lines is not None else result.mesh
    quality = result.arrays[result.per_vertex] if result.per_vertex and result.lines is None else None
    of_faces = result.arrays[result.per_face] if result.per_face else None
    if quality is None and of_faces is None and result.lines is None:
        raise InvalidInput("This result has no value for each vertex, so it is no PLY; choose .npy, .npz or .csv.")
    values = dict(zip("xyz", points.T.astype(float), strict=True)) | result.vertex_values
    if quality is not None:
        values["quality"] = np.where(np.isfinite(quality), quality, result.no_value).astype("f4")
    types = {name: value.dtype.str[1:] if value.dtype.str[1:] in _PLY_TYPES else "f8" for name, value in values.items()}
    vertex = np.zeros(len(points), [(name, "<" + kind) for name, kind in types.items()])
    for name, value in values.items():
        vertex[name] = value
    head = [f"element vertex {len(points)}", *(f"property {_PLY_TYPES[kind]} {name}" for name, kind in types.items())]
    if result.lines is None:
        rows = np.zeros(
            len(cells), [("size", "u1"), ("ids", "<i4", 3), *([] if of_faces is None else [("quality", "<f4")])]
        )
        rows["size"], rows["ids"] = 3, cells
        head += [f"element face {len(cells)}", "property list uchar int vertex_indices"]
        if of_faces is not None:
            rows["quality"] = of_faces
            head.append("property float quality")
    else:
        rows = np.ascontiguousarray(cells, "<i4")
        head += [f"element edge {len(cells)}", "property int vertex1", "property int vertex2"]
    text = "\n".join(["ply", "format binary_little_endian 1.0", *head, "end_header\n"])
    part.write_bytes(text.encode() + vertex.tobytes() + rows.tobytes())


def _gii(result: Result, part: Path) -> None:
    if not result.per_vertex:
        raise InvalidInput(
            "This result has no value for each vertex, so it is no GIFTI file; choose .npy, .npz or .csv."
        )
    try:
        from nibabel.gifti import GiftiDataArray, GiftiImage
    except ImportError:
        raise InvalidInput("GIFTI files are written by nibabel; run 'pip install nibabel', or choose .npy.") from None
    values = result.arrays[result.per_vertex]
    whole = values.dtype.kind == "i"
    data = values.astype(np.int32 if whole else np.float32)
    intent = "NIFTI_INTENT_LABEL" if whole else "NIFTI_INTENT_SHAPE"
    datatype = "NIFTI_TYPE_INT32" if whole else "NIFTI_TYPE_FLOAT32"
    array = GiftiDataArray(data, intent=intent, datatype=datatype)
    GiftiImage(darrays=[array]).to_filename(part)


WRITERS: dict[str, Callable[[Result, Path], None]] = {
    ".npy": _npy,
    ".npz": _npz,
    ".mat": _mat,
    ".csv": _csv,
    ".ply": _ply,
    ".gii": _gii,
}
