"""The destination of a large result: memory, if it fits, or a memory-mapped .npy file."""

from __future__ import annotations

import io
import mmap
import os
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from typing import Any

import numpy as np
from numpy.typing import DTypeLike, NDArray

from . import _arguments as check
from . import _core
from .errors import InvalidInput

Output = str | os.PathLike[str] | NDArray[Any] | None
_Report = Callable[[float, str], object] | None

#: While a mapped file is filled, its pages are released each time so many bytes are written; the file keeps them.
_MAPPED_BYTES = 2**28


def matrix_bytes(rows: int, columns: int, dtype: DTypeLike | None = None) -> int:
    """Bytes that a matrix of distances takes.

    Parameters
    ----------
    rows, columns : int
        Its shape.
    dtype : {float64, float32}, optional
        Of the entries; None is float64.
    """
    size: int = check.real_type(dtype).itemsize
    return size * check.integer("rows", rows, 0, 2**40) * check.integer("columns", columns, 0, 2**40)


@contextmanager
def matrix(
    rows: int, columns: int, out: Output, max_bytes: int | None, dtype: DTypeLike | None = None
) -> Iterator[NDArray[Any]]:
    """An array to fill in the block: new, given, or mapped to a file that appears complete or not at all.

    The file's space is reserved first: writing to mapped memory on a full disk would kill the process.
    InvalidInput if `out` has a wrong shape or type, or names a folder, a device or a pipe, or a file in a folder that
    does not exist; FileError if the disk is full or the file may not be written; NotEnoughMemory if the array does not
    fit into memory.
    """
    if isinstance(out, np.ndarray):
        yield _given(rows, columns, out, dtype)
        return
    entry = check.real_type(dtype)
    size = matrix_bytes(rows, columns, entry)
    if out is None:
        _core.require_memory(
            size,
            check.byte_limit(max_bytes),
            f"The matrix of {rows} x {columns} distances",
            "Give fewer points, dtype='float32', or out='file.npy' to write it to a file.",
        )
        yield np.empty((rows, columns), entry)
        return
    head = _head(rows, columns, entry)
    file = _core.OutputFile.make(check.file_path(out), "out: the file", head, size)
    try:
        if rows * columns == 0:
            yield np.empty((rows, columns), entry)
        else:
            with open(file.temporary, "r+b", opener=_OPENER) as opened:
                array = np.memmap(opened, entry, "r+", len(head), (rows, columns))
            yield array
            array.flush()
        file.finish()
    finally:
        file.discard()


def reopened(result: NDArray[Any], out: Output) -> NDArray[Any]:
    """The result; if it went to a file, that file mapped read-only under its final name."""
    if out is None or isinstance(out, np.ndarray) or result.size == 0:
        return result
    rows, columns = result.shape
    with open(check.file_path(out), "rb", opener=_OPENER) as opened:
        return np.memmap(opened, result.dtype, "r", len(_head(rows, columns, result.dtype)), (rows, columns))


def _open_shared(name: str | os.PathLike[str], flags: int) -> int:
    """Open a file so that others may rename and replace it, which Windows does not allow unless it is asked to."""
    if sys.platform != "win32":
        return os.open(name, flags)
    import ctypes
    import msvcrt

    read, write, share_read_write_delete, existing = 0x80000000, 0x40000000, 7, 3
    access = read | (write if flags & os.O_RDWR else 0)
    create = ctypes.WinDLL("kernel32", use_last_error=True).CreateFileW
    create.restype = ctypes.c_void_p
    handle = create(ctypes.c_wchar_p(os.fspath(name)), access, share_read_write_delete, None, existing, 0, None)
    if handle == ctypes.c_void_p(-1).value:
        raise ctypes.WinError(ctypes.get_last_error())
    return msvcrt.open_osfhandle(handle, flags)


_OPENER = _open_shared if sys.platform == "win32" else None


def _given(rows: int, columns: int, out: NDArray[Any], dtype: DTypeLike | None) -> NDArray[Any]:
    """The caller's array, if it can hold the result."""
    real = out.dtype in (np.float32, np.float64) if dtype is None else out.dtype == check.real_type(dtype)
    if out.shape != (rows, columns) or not real or not out.flags.c_contiguous:
        wanted = "float64 or float32" if dtype is None else check.real_type(dtype)
        raise InvalidInput(
            f"out: is an array of {out.dtype} and shape {out.shape}; give a contiguous one of {wanted} and shape "
            f"({rows}, {columns})."
        )
    if not out.flags.writeable:
        raise InvalidInput("out: is read-only; give an array that can be written, or the name of a file.")
    return out


def releasing(array: NDArray[Any], report: _Report) -> _Report:
    """The progress function; while a large mapped file is filled, it also releases the pages that are written."""
    mapped: mmap.mmap | None = getattr(array, "_mmap", None)
    if mapped is None or array.nbytes <= _MAPPED_BYTES or not hasattr(mmap, "MADV_DONTNEED"):
        return report
    released = 0.0

    def report_and_release(fraction: float, text: str) -> object:
        nonlocal released
        if (fraction - released) * array.nbytes > _MAPPED_BYTES:
            released = fraction
            mapped.madvise(mmap.MADV_DONTNEED)
        return None if report is None else report(fraction, text)

    return report_and_release


def _head(rows: int, columns: int, entry: np.dtype[Any]) -> bytes:
    """The beginning of a .npy file of this matrix."""
    head = io.BytesIO()
    dtype = np.lib.format.dtype_to_descr(entry)
    np.lib.format.write_array_header_1_0(head, {"descr": dtype, "fortran_order": False, "shape": (rows, columns)})
    return head.getvalue()
