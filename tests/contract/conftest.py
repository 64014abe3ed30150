"""The seed of a run: printed at its start and with every test that fails; and a random generator for each test."""

from __future__ import annotations

import zlib

import numpy as np
import pytest
from table import SEED


def pytest_report_header() -> str:
    """How to repeat this run."""
    return f"contract: VOROGEO_CONTRACT_SEED={SEED} repeats this run"


@pytest.fixture(autouse=True)
def random(request: pytest.FixtureRequest) -> np.random.Generator:
    """Random numbers of this test in this run."""
    print(f"VOROGEO_CONTRACT_SEED={SEED} repeats this test")
    return np.random.default_rng([SEED, zlib.crc32(request.node.nodeid.encode())])
