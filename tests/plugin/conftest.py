"""What the plugin tests share: the plugin loaded into the real PyMeshLab, and fixtures around it.

They run with whichever supported PyMeshLab the running Python has; see test_older_pymeshlab.py for the other one.
"""

from __future__ import annotations

import os
from pathlib import Path

import pymeshlab
import pytest
from support import PROJECT, host_version

MESHES = Path(os.environ.get("VOROGEO_MESHES", PROJECT.parent / "shared" / "meshes"))


def _load(file: Path, first_filter: str) -> None:
    if first_filter in pymeshlab.filter_list():
        return
    if not file.is_file():
        pytest.exit(f"There is no {file}: run 'bash samples/setup.sh --tests' first.", returncode=1)
    pymeshlab.load_plugin(str(file))


def pytest_configure(config: pytest.Config) -> None:
    """Load the plugin and the probe before any test: a plugin cannot be unloaded from PyMeshLab."""
    build = Path(os.environ.get("VOROGEO_PLUGIN_BUILD", PROJECT / "build" / f"plugin-{host_version()}-double"))
    _load(build / "plugin" / "libfilter_vorogeo.so", "compute_geodesic_index_by_vorogeo")
    _load(build / "plugin" / "probe" / "libfilter_probe.so", "probe_apply")


@pytest.fixture
def real_mesh():
    """Path of a mesh that comes with PyMeshLab ("cow.obj") or is in the shared folder; skips where there is none."""

    def path(name: str) -> str:
        samples = Path(pymeshlab.__file__).parent / "tests" / "sample_meshes"
        file = samples / name if "." in name else MESHES / f"{name}.ply"
        if not file.is_file():
            pytest.skip(f"there is no {file}")
        return str(file)

    return path
