"""Which gaps of a surface are bridged."""

from __future__ import annotations

import math

from . import _arguments as check
from .errors import InvalidInput

GapLimit = tuple[float, bool]
"""The widest gap to bridge, and whether also where the surface turns back."""


def gap_limit(gap: float | None, bridge_folds: bool) -> GapLimit:
    """The two arguments, checked.

    Raises
    ------
    InvalidInput
        (a ValueError) If the gap is negative or not finite.
    """
    wanted = "a finite length of 0 or more in the unit of the vertices"
    number = 0.0 if gap is None else check.real("gap", gap, wanted)
    if not 0 <= number < math.inf:
        raise InvalidInput(f"gap: {number} is out of range; give {wanted}.")
    return number, bool(bridge_folds)
