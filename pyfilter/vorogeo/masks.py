"""Masks: parts of a mesh that distances neither cross nor see; results go on referring to the mesh as given."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .errors import InvalidInput


def face_mask(mask: ArrayLike | None, faces: NDArray[np.int32], vertex_count: int) -> NDArray[np.bool_] | None:
    """Which faces belong to the surface, read-only; None if all do.

    Raises
    ------
    InvalidInput
        (a ValueError) If the mask has neither a value for each face nor one for each vertex, or values other than
        false and true.
    """
    if mask is None:
        return None
    wanted = (
        f"one value for each of the {len(faces)} faces or {vertex_count} vertices, True where it belongs to the surface"
    )
    try:
        given: NDArray[Any] = np.asarray(mask)
    except (TypeError, ValueError) as error:
        raise InvalidInput(f"mask: cannot be read as an array ({error}); give {wanted}.") from None
    if given.shape not in ((len(faces),), (vertex_count,)):
        raise InvalidInput(f"mask: has shape {given.shape}; give {wanted}.")
    if given.dtype.kind not in "biuf" or not np.isin(given, (0, 1)).all():
        row = int(np.flatnonzero(~np.isin(given, (0, 1)))[0]) if given.dtype.kind in "biuf" else 0
        raise InvalidInput(f"mask[{row}]: is {given[row]!r}, neither False nor True; give {wanted}.")
    kept: NDArray[np.bool_] = given.astype(bool)
    if len(given) != len(faces):
        kept = np.logical_and.reduce(kept[faces], axis=1)
    kept.flags.writeable = False
    return kept


def without_masked(faces: NDArray[np.int32], mask: NDArray[np.bool_] | None) -> NDArray[np.int32]:
    """The faces for the core: it leaves out those that name a vertex twice, and goes on counting them."""
    return faces if mask is None else np.where(mask[:, None], faces, np.int32(0))
