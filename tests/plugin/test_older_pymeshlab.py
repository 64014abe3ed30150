"""Runs all other plugin tests with the older supported PyMeshLab versions, each in a Python of its own."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest
from support import PROJECT, host_version


@pytest.mark.skipif(host_version() != "2025.07", reason="this is an older PyMeshLab")
@pytest.mark.parametrize("year", [2022, 2023])
def test_all_plugin_tests_pass_with_pymeshlab_of(year):
    python = PROJECT / "build" / f"venv-{year}" / "bin" / "python"
    if not python.is_file():
        pytest.skip(f"there is no {python}: 'bash samples/setup.sh --tests' makes it where the headers can be had")
    environment = {
        key: value for key, value in os.environ.items() if not key.startswith(("PYTEST_", "VOROGEO_PLUGIN_"))
    }
    run = subprocess.run(
        [python, "-m", "pytest", "-q", "-p", "no:cacheprovider", Path(__file__).parent],
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0, run.stdout[-6000:] + run.stderr[-2000:]
