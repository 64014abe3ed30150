"""The destination of a large result: memory, if it fits, or a memory-mapped .npy file."""

from __future__ import annotations

import io
import os
from collections.abc import Iterator
from contextlib import contextmanager

import numpy as np
from numpy.typing import NDArray

from . import _arguments as check
from . import _core
from .errors import InvalidInput, NotEnoughMemory

Output = str | os.PathLike[str] | NDArray[np.float64] | None


def matrix_bytes(rows: int, columns: int) -> int:
    """Bytes that a matrix of float64 distances takes.

    Parameters
    ----------
    rows, columns : int
        Its shape.
    """
    return 8 * check.integer("rows", rows, 0, 2**40) * check.integer("columns", columns, 0, 2**40)


def require_memory(what: str, needed: float, max_bytes: int | None, advice: str) -> None:
    """Raise NotEnoughMemory if `needed` bytes are more than allowed or, without a limit, available."""
    limit = check.byte_limit(max_bytes) or _core.available_memory_bytes()
    if needed > limit:
        bound = "available" if max_bytes is None else "allowed by max_bytes"
        raise NotEnoughMemory(
            f"{what} takes {needed / 2**30:.3g} GiB, more than the {limit / 2**30:.3g} GiB {bound}; {advice}"
        )


@contextmanager
def matrix(rows: int, columns: int, out: Output, max_bytes: int | None) -> Iterator[NDArray[np.float64]]:
    """An array of float64 to fill in the block: new, given, or mapped to a file that appears complete or not at all.

    The file's space is reserved first: writing to mapped memory on a full disk would kill the process.

    Raises
    ------
    InvalidInput
        If `out` has a wrong shape or type, or names a folder, a device or a pipe, or a file in a folder that does not
        exist.
    FileError
        (an OSError) If the disk is full or the file may not be written.
    NotEnoughMemory
        If the array does not fit into memory.
    """
    if out is None:
        require_memory(
            f"The matrix of {rows} x {columns} distances", matrix_bytes(rows, columns), max_bytes,
            "give fewer points, or out='file.npy' to write it to a file.",
        )  # fmt: skip
        yield np.empty((rows, columns))
    elif isinstance(out, np.ndarray):
        if out.shape != (rows, columns) or out.dtype != np.float64 or not out.flags.c_contiguous:
            raise InvalidInput(
                f"out: is an array of {out.dtype} and shape {out.shape}; give a contiguous one of float64 and shape "
                f"({rows}, {columns})."
            )
        if not out.flags.writeable:
            raise InvalidInput("out: is read-only; give an array that can be written, or the name of a file.")
        yield out
    else:
        head = _head(rows, columns)
        file = _core.OutputFile.make(check.file_path(out), "out: the file", head, matrix_bytes(rows, columns))
        try:
            if rows * columns == 0:
                yield np.empty((rows, columns))
            else:
                array = np.memmap(file.temporary, np.float64, "r+", len(head), (rows, columns))
                yield array
                array.flush()
            file.finish()
        finally:
            file.discard()


def _head(rows: int, columns: int) -> bytes:
    """The beginning of a .npy file of this matrix."""
    head = io.BytesIO()
    dtype = np.lib.format.dtype_to_descr(np.dtype(np.float64))
    np.lib.format.write_array_header_1_0(head, {"descr": dtype, "fortran_order": False, "shape": (rows, columns)})
    return head.getvalue()
