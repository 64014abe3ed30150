"""Runs all other plugin tests with the older supported PyMeshLab, in a Python of its own."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest
from support import PROJECT, host_version

# absolute() and not resolve(): the link to the interpreter is what makes it the virtual environment's
OLDER_PYTHON = Path(
    os.environ.get("VOROGEO_OLDER_PYTHON", PROJECT / "build" / "venv-2022" / "bin" / "python")
).absolute()


@pytest.mark.skipif(host_version() == "2022.02", reason="this is the older PyMeshLab")
def test_all_plugin_tests_pass_with_pymeshlab_2022():
    if not OLDER_PYTHON.is_file():
        pytest.skip(f"there is no {OLDER_PYTHON}: run 'bash samples/setup.sh --tests'")
    environment = {
        key: value for key, value in os.environ.items() if not key.startswith(("PYTEST_", "VOROGEO_PLUGIN_"))
    }
    run = subprocess.run(
        [OLDER_PYTHON, "-m", "pytest", "-q", "-p", "no:cacheprovider", Path(__file__).parent],
        env=environment,
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0, run.stdout[-6000:] + run.stderr[-2000:]
