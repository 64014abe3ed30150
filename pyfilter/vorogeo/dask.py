"""Distance matrices that are larger than memory or made by many machines: lazy dask arrays by blocks of rows."""

from __future__ import annotations

import os
import pickle
import shutil
import tempfile
import weakref
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from . import _arguments as check
from .errors import InvalidInput
from .mesh_files import read_mesh
from .mesh_input import MeshInput
from .metrics import Metric
from .surface import GeodesicIndex, Surface
from .tasks import Shared

_BLOCK_BYTES = 2**25


@dataclass(frozen=True)
class IndexFiles:
    """Where workers find an index file and its mesh as a pickle; and the number of vertices."""

    index: str
    mesh: str
    vertex_count: int

    def open(self) -> GeodesicIndex:
        """The index, read once in each process; its calls use one thread, as a worker runs several tasks at a time."""
        return _opened(self)


@lru_cache(maxsize=2)
def _opened(files: IndexFiles) -> GeodesicIndex:
    given: MeshInput = pickle.loads(Path(files.mesh).read_bytes())
    return GeodesicIndex.of(Shared(given, 1, 0, given.core_mesh().load_index(files.index, 1, True)))


def write_files(
    index: GeodesicIndex | str | os.PathLike[str],
    folder: str,
    mesh: tuple[ArrayLike, ArrayLike] | str | os.PathLike[str] | None = None,
    mask: ArrayLike | None = None,
    metric: Metric | None = None,
    gap: float = 0.0,
    bridge_folds: bool = False,
) -> IndexFiles:
    """Put what workers need into a folder that all of them see; with an index file, its mesh must be given."""
    if not isinstance(index, GeodesicIndex):
        if isinstance(index, Surface):
            raise InvalidInput("index: is a surface; give a GeodesicIndex, or the file of an index and its mesh.")
        if mesh is None:
            raise InvalidInput(
                "mesh: is missing; an index file does not hold the mesh, so give its file or its arrays."
            )
        vertices, faces = read_mesh(mesh) if isinstance(mesh, (str, os.PathLike)) else mesh
        file = os.path.abspath(check.file_path(index))
        index = GeodesicIndex.load(file, vertices, faces, None, mask, metric, gap, bridge_folds)
    else:
        file = os.path.join(folder, "index.vgi")
        index.save(file)
    mesh_file = os.path.join(folder, "mesh.pickle")
    Path(mesh_file).write_bytes(pickle.dumps(index._shared.given, pickle.HIGHEST_PROTOCOL))
    return IndexFiles(file, mesh_file, len(index.vertices))


def matrix_rows(
    files: IndexFiles,
    rows: NDArray[Any],
    columns: NDArray[Any] | None,
    dtype: str,
    method: str | None,
    entries: str = "fields",
) -> NDArray[Any]:
    """What one task computes: rows of the matrix, from the field of each or by pairs."""
    index = files.open()
    if entries == "pairs":
        others = np.arange(files.vertex_count, dtype=np.int32) if columns is None else columns
        return index.distance_matrix(rows, others, entries=entries, dtype=dtype, method=method)
    fields = index.fields(rows, dtype=dtype, method=method)
    return fields if columns is None else fields[:, columns]


def blocks_of(count: int, columns: int, itemsize: int, rows: int | None) -> list[tuple[int, int]]:
    """First row of each block and the row after its last; by default blocks of 32 MiB, and at least eight."""
    height = rows or max(1, min(_BLOCK_BYTES // max(1, columns * itemsize), -(-count // 8)))
    return [(first, min(count, first + height)) for first in range(0, count, height)]


def matrix(
    index: GeodesicIndex | str | os.PathLike[str],
    dtype: DTypeLike = np.float64,
    points: ArrayLike | None = None,
    mesh: tuple[ArrayLike, ArrayLike] | str | os.PathLike[str] | None = None,
    mask: ArrayLike | None = None,
    metric: Metric | None = None,
    method: str | None = None,
    rows: int | None = None,
    folder: str | os.PathLike[str] | None = None,
    gap: float = 0.0,
    bridge_folds: bool = False,
    entries: str = "fields",
) -> Any:
    """Distances between all vertices, or chosen ones, as a lazy dask array.

    Parameters
    ----------
    index : GeodesicIndex, str or path
        The index, or the file of one.
    dtype : {float64, float32}
        Of the entries.
    points : array_like of int, shape (k,), optional
        Vertex ids of the rows and columns; None is all vertices.
    mesh : (vertices, faces) or a file that `read_mesh` reads, optional
        Needed with an index file.
    mask, metric, gap, bridge_folds
        Those with which the index in the file was built.
    method : str, optional
        As for `Surface`: "exact" propagates instead of asking the index.
    rows : int, optional
        Rows of each block; None is as many as take some 32 MiB.
    folder : str or path, optional
        Where the index and the mesh are put for the workers, which must see it; None is a temporary folder that is
        deleted with the array.
    entries : {"fields", "pairs"}
        Whether rows are fields, or each entry is asked for alone, as for `GeodesicIndex.distance_matrix`.

    Returns
    -------
    dask.array.Array, shape (n, n) or (k, k)
        Entry (i, j) of fields is read from that of i, so that it may differ from entry (j, i) by the errors of the
        index. Infinity where no path leads. Nothing is computed yet: ``store`` or ``to_zarr`` it, or ``compute`` parts.

    Notes
    -----
    Each worker process loads the index file once, by mapping (errors are those of `GeodesicIndex.load`); only its name
    travels. A block that is lost with its worker is computed again.
    """
    from dask import array, delayed

    entry = check.real_type(dtype)
    check.choice("entries", entries, ("fields", "pairs"))
    temporary = folder is None
    place = tempfile.mkdtemp(prefix="vorogeo-") if folder is None else os.path.abspath(folder)
    try:
        os.makedirs(place, exist_ok=True)
        files = write_files(index, place, mesh, mask, metric, gap, bridge_folds)
        count = files.vertex_count
        ids = np.arange(count, dtype=np.int32) if points is None else check.vertex_ids("points", points, count)
        columns = None if points is None else ids
        height = None if rows is None else check.integer("rows", rows, 1, 2**31 - 1)
        compute = delayed(matrix_rows, pure=True)
        parts = [
            array.from_delayed(
                compute(files, ids[first:last], columns, entry.name, method, entries),
                (last - first, len(ids)),
                dtype=entry,
            )
            for first, last in blocks_of(len(ids), len(ids), entry.itemsize, height)
        ]
        whole = array.concatenate(parts) if parts else array.zeros((0, 0), dtype=entry)
    except BaseException:
        if temporary:
            shutil.rmtree(place, ignore_errors=True)
        raise
    if temporary:
        weakref.finalize(whole, shutil.rmtree, place, ignore_errors=True)
    return whole
