"""What a script saw, for the tests that judge it: `test_NAME.py` judges NAME.py unless it names another SCRIPT."""

from __future__ import annotations

import pytest
from results import written_down


@pytest.fixture(scope="module")
def seen(request: pytest.FixtureRequest) -> dict:
    """What the script saw that the module judges."""
    return written_down(getattr(request.module, "SCRIPT", request.module.__name__.removeprefix("test_")))
