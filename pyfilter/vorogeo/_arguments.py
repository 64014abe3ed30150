"""Checks arguments and turns them into the arrays that the compiled core takes."""

from __future__ import annotations

import math
import operator
import os
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from .errors import InvalidInput

MAX_THREADS = 1024
_INT32 = np.iinfo(np.int32)


def as_numpy(value: Any) -> NDArray[Any]:
    """An array of any library on the CPU, without a copy where that is possible."""
    if getattr(value, "requires_grad", False):  # torch refuses to convert tensors that record gradients
        value = value.detach()
    if hasattr(value, "__dlpack__") and not hasattr(value, "__array__"):
        return np.from_dlpack(value)
    return np.asarray(value)


def numbers(name: str, value: Any, wanted: str) -> NDArray[Any]:
    """An array of integers, real numbers or bools."""
    try:
        array = as_numpy(value)
    except (TypeError, ValueError, RuntimeError, BufferError) as error:
        raise InvalidInput(f"{name}: cannot be read as an array ({error}); give {wanted}.") from None
    if np.ma.is_masked(value):
        raise InvalidInput(f"{name}: has masked entries; give {wanted}, without them.")
    if array.dtype.kind not in "fiub":
        raise InvalidInput(f"{name}: is not an array of numbers (it is {_describe(value, array)}); give {wanted}.")
    return array


def _describe(value: Any, array: NDArray[Any]) -> str:
    if array.ndim == 0 and not isinstance(value, np.ndarray):
        return type(value).__name__
    return f"an array of {array.dtype}"


def _triples(name: str, array: NDArray[Any], wanted: str, width: int = 3) -> None:
    if array.ndim != 2 or array.shape[1] != width:
        raise InvalidInput(f"{name}: has shape {array.shape}; give {wanted}.")


def integers(name: str, array: NDArray[Any], wanted: str) -> NDArray[Any]:
    """An array of integers, also from whole numbers that are stored as reals, as matrices in files have them."""
    if array.dtype.kind in "iu":
        return array
    where = ""
    if array.dtype.kind == "f":
        is_whole = np.isfinite(array) & (array == np.rint(array))
        if is_whole.all():
            return np.clip(array.astype(np.float64), -(2.0**62), 2.0**62).astype(np.int64)
        row = "".join(f"[{i}]" for i in np.argwhere(~is_whole)[0])
        where = f": {name}{row} is {array[~is_whole][0]}"
    raise InvalidInput(f"{name}: has type {array.dtype}, not integer{where}; give {wanted}.")


def column(array: NDArray[Any]) -> NDArray[Any]:
    """An array of shape (k,) also where it is a column, as matrices in files have it."""
    return array[:, 0] if array.ndim == 2 and array.shape[1] == 1 else array


def vertices(value: ArrayLike, finite: bool = True) -> NDArray[np.float64]:
    """Vertex positions as contiguous float64 of shape (n, 3); finite unless told otherwise."""
    wanted = "the positions as real numbers of shape (n, 3)"
    array = numbers("vertices", value, wanted)
    _triples("vertices", array, wanted)
    if array.dtype.kind == "b":
        raise InvalidInput(f"vertices: has type bool; give {wanted}.")
    if len(array) > _INT32.max:
        raise InvalidInput(f"vertices: has {len(array)} rows; at most {_INT32.max} are possible.")
    points = np.ascontiguousarray(array, dtype=np.float64)
    if finite:
        _finite("vertices", points, "repair or remove this vertex and its faces")
    return points


def _finite(name: str, points: NDArray[np.float64], advice: str) -> None:
    bad = ~np.isfinite(points).all(axis=1)
    if bad.any():
        row = int(np.flatnonzero(bad)[0])
        raise InvalidInput(f"{name}[{row}]: {points[row].tolist()} is not finite; {advice}.")


def faces(value: ArrayLike, vertex_count: int) -> NDArray[np.int32]:
    """Faces as contiguous int32 of shape (m, 3), each entry in [0, vertex_count)."""
    array = _face_array(value)
    bad = (array < 0) | (array >= vertex_count)
    if bad.any():
        row = int(np.flatnonzero(bad.any(axis=1))[0])
        vertex = int(array[row][bad[row]][0])
        raise InvalidInput(f"faces[{row}]: names vertex {vertex}, but {vertex_range(vertex_count)}.")
    return np.ascontiguousarray(array, dtype=np.int32)


def kept(array: NDArray[Any], given: Any) -> NDArray[Any]:
    """The array read-only, as a copy if the caller could change it through the one given."""
    own = array.copy() if np.may_share_memory(array, as_numpy(given)) else array
    own.flags.writeable = False
    return own


def unchecked_faces(value: ArrayLike) -> NDArray[np.int32]:
    """Faces as contiguous int32 of shape (m, 3); entries out of int32's range become -1 or the largest int32."""
    array = _face_array(value)
    wide = array.astype(np.uint64 if array.dtype.kind == "u" else np.int64)
    wide[wide > _INT32.max] = _INT32.max
    if array.dtype.kind == "i":
        wide[wide < 0] = -1
    return np.ascontiguousarray(wide, dtype=np.int32)


def _face_array(value: ArrayLike) -> NDArray[Any]:
    wanted = "the vertex ids of the triangles as integers of shape (m, 3)"
    array = numbers("faces", value, wanted)
    _triples("faces", array, wanted)
    if len(array) > _INT32.max // 3:
        raise InvalidInput(f"faces: has {len(array)} rows; at most {_INT32.max // 3} are possible.")
    return integers("faces", array, wanted)


def vertex_range(vertex_count: int) -> str:
    """Which vertices there are, for the end of a sentence."""
    if vertex_count == 0:
        return "the mesh has no vertices"
    return f"the mesh has vertices 0 to {vertex_count - 1}"


def vertex_ids(name: str, value: ArrayLike, vertex_count: int) -> NDArray[np.int32]:
    """Any number of vertex ids, possibly none, as contiguous int32 of shape (k,), each in [0, vertex_count)."""
    wanted = "a vertex id or a one-dimensional array of vertex ids (integers)"
    array = column(numbers(name, value, wanted))
    if array.ndim > 1:
        raise InvalidInput(f"{name}: has shape {array.shape}; give {wanted}.")
    if array.size == 0:
        return np.empty(0, dtype=np.int32)
    array = integers(name, array, wanted)
    bad = (array < 0) | (array >= vertex_count)
    if bad.any():
        place = "" if array.ndim == 0 else f"[{int(np.flatnonzero(bad)[0])}]"
        vertex = int(array[bad][0])
        raise InvalidInput(f"{name}{place}: there is no vertex {vertex}; {vertex_range(vertex_count)}.")
    return np.ascontiguousarray(array, dtype=np.int32).reshape(-1)


def source_ids(value: ArrayLike, vertex_count: int, name: str = "sources") -> NDArray[np.int32]:
    """One or more vertex ids as int32 of shape (k,), k >= 1."""
    ids = vertex_ids(name, value, vertex_count)
    if ids.size == 0:
        raise InvalidInput(f"{name}: is empty; give at least one vertex id.")
    return ids


def integer(name: str, value: Any, low: int, high: int) -> int:
    """An integer in [low, high]."""
    try:
        if isinstance(value, (bool, np.bool_)):
            raise TypeError
        number = operator.index(value)
    except TypeError:
        raise InvalidInput(f"{name}: {value!r} is not an integer; give one from {low} to {high}.") from None
    if not low <= number <= high:
        raise InvalidInput(f"{name}: {number} is out of range; give an integer from {low} to {high}.")
    return number


def real(name: str, value: Any, wanted: str) -> float:
    """A real number that is not NaN."""
    try:
        if isinstance(value, (bool, np.bool_, str, bytes)):
            raise TypeError
        number = float(value)
    except (TypeError, ValueError, OverflowError):
        raise InvalidInput(f"{name}: {value!r} is not a real number; give {wanted}.") from None
    if math.isnan(number):
        raise InvalidInput(f"{name}: is NaN; give {wanted}.")
    return number


def max_distance(value: float | None) -> float:
    """A distance limit; infinity for None."""
    return math.inf if value is None else length("max_distance", value, ", or None for no limit")


def delta(value: float) -> float:
    """The pruning threshold, in [0, 1)."""
    wanted = "a relative error from 0 (nothing is lost) to below 1"
    number = real("delta", value, wanted)
    if not 0 <= number < 1:
        raise InvalidInput(f"delta: {number} is out of range; give {wanted}.")
    return number


def patches(value: tuple[int, int] | None) -> tuple[int, int]:
    """The numbers of patches (n1, n2); 0 means that it is chosen from the mesh."""
    if value is None:
        return 0, 0
    wanted = "None or two integers (n1, n2), 0 for an automatic number"
    if isinstance(value, (str, bytes)):
        raise InvalidInput(f"patches: {value!r} is not a pair; give {wanted}.")
    try:
        pair = list(value)
    except TypeError:
        raise InvalidInput(f"patches: {value!r} is not a pair; give {wanted}.") from None
    if len(pair) != 2:
        raise InvalidInput(f"patches: has {len(pair)} entries; give {wanted}.")
    return integer("patches[0]", pair[0], 0, _INT32.max), integer("patches[1]", pair[1], 0, _INT32.max)


def real_type(value: DTypeLike | None) -> np.dtype[Any]:
    """The type of results: float32 or float64, which None stands for."""
    wanted = "give float32 or float64"
    try:
        found = np.dtype(np.float64 if value is None else value)
    except TypeError:
        raise InvalidInput(f"dtype: {value!r} is no type of numbers; {wanted}.") from None
    if found not in (np.float32, np.float64):
        raise InvalidInput(f"dtype: {found} is not possible; {wanted}.")
    return found


def threads(value: int | None) -> int:
    """Number of threads; 0 for None, which means one per core."""
    return 0 if value is None else integer("threads", value, 1, MAX_THREADS)


def memory_budget(value: int | None) -> int:
    """MiB that an index may take; 0 for None, which stands for the default."""
    return 0 if value is None else integer("memory_budget", value, 1, _INT32.max)


def file_path(value: str | os.PathLike[str]) -> str:
    """A file name without NUL characters."""
    try:
        path = os.fsdecode(value)
    except (TypeError, ValueError):
        raise InvalidInput(f"file: {value!r} is not a file name; give a string or a path.") from None
    if "\0" in path:
        raise InvalidInput(f"file: {value!r} holds a NUL character; give another name.")
    if not path:
        raise InvalidInput("file: is empty; give a file name.")
    return path


def length(name: str, value: Any, otherwise: str = "") -> float:
    """A length of 0 or more; infinity is allowed. `otherwise`: what else is accepted, for the message."""
    wanted = f"a length of 0 or more in the unit of the vertices{otherwise}"
    number = real(name, value, wanted)
    if number < 0:
        raise InvalidInput(f"{name}: {number} is negative; give {wanted}.")
    return number


def angle(name: str, value: Any) -> float:
    """An angle in [0, pi]."""
    wanted = "an angle from 0 to pi, in radians"
    number = real(name, value, wanted)
    if not 0 <= number <= math.pi:
        raise InvalidInput(f"{name}: {number} is out of range; give {wanted}.")
    return number


def byte_limit(value: int | None) -> int:
    """A limit in bytes; 0 for None, which stands for the available memory."""
    return 0 if value is None else integer("max_bytes", value, 1, 2**63 - 1)


def choice(name: str, value: str, choices: tuple[str, ...]) -> int:
    """The position of a word among those allowed."""
    if value not in choices:
        raise InvalidInput(f"{name}: {value!r} is unknown; give one of {', '.join(map(repr, choices))}.")
    return choices.index(value)


def real_values(name: str, value: ArrayLike) -> NDArray[np.float64]:
    """Real numbers as contiguous float64 of shape (k,); a single one as shape (1,)."""
    wanted = "a one-dimensional array of real numbers"
    array = np.atleast_1d(numbers(name, value, wanted))
    if array.ndim != 1 or array.dtype.kind == "b":
        raise InvalidInput(f"{name}: has shape {array.shape} and type {array.dtype}; give {wanted}.")
    return np.ascontiguousarray(array, dtype=np.float64)


def positions(name: str, value: ArrayLike, width: int = 3) -> NDArray[np.float64]:
    """Finite rows of real numbers as contiguous float64 of shape (k, width); a single row is treated as k = 1."""
    wanted = f"finite real numbers of shape ({width},) or (k, {width})"
    array = np.atleast_2d(numbers(name, value, wanted))
    if array.size == 0:
        return np.empty((0, width))
    _triples(name, array, wanted, width)
    points = np.ascontiguousarray(array, dtype=np.float64)
    _finite(name, points, f"give {wanted}")
    return points


def direction(name: str, value: ArrayLike) -> tuple[float, float, float]:
    """A vector of shape (3,) that is not 0."""
    found = positions(name, value)
    if found.shape != (1, 3) or not found.any():
        raise InvalidInput(f"{name}: is {np.asarray(value).tolist()}; give three numbers that are not all 0.")
    x, y, z = found[0].tolist()
    return x, y, z


def offsets(value: ArrayLike | None, count: int) -> NDArray[np.float64]:
    """Offsets of the sources as float64 of shape (count,), finite and not negative; zeros for None."""
    if value is None:
        return np.zeros(count)
    return not_negative("offsets", value, count, "lengths of 0 or more, one for each source")


def not_negative(name: str, value: ArrayLike, count: int, wanted: str) -> NDArray[np.float64]:
    """Numbers as float64 of shape (count,), finite and not negative."""
    wanted = f"{count} {wanted}"
    array = np.atleast_1d(numbers(name, value, wanted))
    if array.shape != (count,):
        raise InvalidInput(f"{name}: has shape {array.shape}; give {wanted}.")
    lengths = np.ascontiguousarray(array, dtype=np.float64)
    bad = ~(np.isfinite(lengths) & (lengths >= 0))
    if bad.any():
        row = int(np.flatnonzero(bad)[0])
        raise InvalidInput(f"{name}[{row}]: is {lengths[row]}; give {wanted}.")
    return lengths
