"""An index as bytes and back: what pickle needs, through a temporary index file."""

from __future__ import annotations

import tempfile
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from . import _core
from .metrics import CoreSides


def saved(handle: _core.Index) -> NDArray[np.uint8]:
    """The contents of the index file; an array, which pickle can hand over without a copy.

    Raises
    ------
    IndexFileError
        (an OSError) If there is no room for the temporary file.
    """
    with tempfile.TemporaryDirectory(prefix="vorogeo-") as folder:
        file = Path(folder) / "index.vgi"
        handle.save(file)
        return np.fromfile(file, np.uint8)


def loaded(
    contents: NDArray[np.uint8],
    vertices: NDArray[np.float64],
    faces: NDArray[np.int32],
    sides: CoreSides | None,
    threads: int,
    gap: tuple[float, bool],
) -> _core.Index:
    """The index of this mesh from the contents of its file.

    Raises
    ------
    IndexFileError
        (an OSError) If the contents are damaged, of another version or of another mesh.
    """
    with tempfile.TemporaryDirectory(prefix="vorogeo-") as folder:
        file = Path(folder) / "index.vgi"
        contents.tofile(file)
        return _core.Index.load(file, vertices, faces, sides, threads, *gap, mapped=False)  # the file goes
