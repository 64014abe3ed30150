"""What the scripts wrote down."""

from __future__ import annotations

import json
import os
from pathlib import Path
from typing import Any

import pytest

PROJECT = Path(__file__).resolve().parents[2]
FOLDER = Path(os.environ.get("VOROGEO_WINDOW_RESULTS", PROJECT / "build" / "window" / "2025.07" / "seen"))


def written_down(name: str) -> Any:
    """Everything that a script of this name wrote down."""
    file = FOLDER / f"{name}.json"
    if not file.is_file():
        pytest.fail(f"there is no {file}: the window was not driven (see {FOLDER / f'{name}-run.log'})")
    return json.loads(file.read_text())
