"""The command doctor: versions, the filters of PyMeshLab or why they are missing, and the processor."""

from __future__ import annotations

import json
import platform
from importlib import metadata
from pathlib import Path
from typing import Any

from ..errors import PluginError
from ..plugin import load_plugin, plugin_file
from .batch import cores

#: What the package uses where it is there, and what for.
_USES = {
    "numpy": "all arrays",
    "scipy": "sparse results, .mat files",
    "meshio": "mesh files",
    "pymeshlab": "filters, mesh files",
    "nibabel": "surfaces of brains",
    "tqdm": "bars of progress",
    "pyvista": "pictures",
    "dask": "clusters",
}


def tell(as_json: bool) -> None:
    """Print the report, as lines or as one JSON object."""
    found = report()
    if as_json:
        print(json.dumps({"command": "doctor", **found}))
        return
    packages, processor, plugin = (found[name] for name in ("packages", "processor", "plugin"))
    missing = [f"{name} ({use})" for name, use in _USES.items() if packages[name] is None]
    print(f"vorogeo {found['vorogeo']} in {found['folder']}")
    print(f"Python {found['python']} on {found['platform']}")
    print(f"with {', '.join(f'{name} {version}' for name, version in packages.items() if version)}")
    if missing:
        print(f"without {', '.join(missing)}")
    print(f"{plugin['filters']} filters from {plugin['file']}" if plugin["filters"] else f"no filters: {plugin['why']}")
    print(f"{processor['model']}, cores: {processor['cores']}, {processor['instructions']} in use")


def report() -> dict[str, Any]:
    """What is there and what is not."""
    packages = {name: _version(name) for name in _USES}
    return {
        "vorogeo": _version("vorogeo"),
        "folder": str(Path(__file__).parents[1]),
        "python": platform.python_version(),
        "platform": platform.platform(),
        "packages": packages,
        "plugin": _plugin(packages["pymeshlab"] or ""),
        "processor": _processor(),
    }


def _version(package: str) -> str | None:
    try:
        return metadata.version(package)
    except metadata.PackageNotFoundError:
        return None


def _plugin(pymeshlab: str) -> dict[str, Any]:
    try:
        return {"filters": len(load_plugin()), "file": str(plugin_file(pymeshlab)), "why": None}
    except PluginError as error:
        return {"filters": 0, "file": None, "why": str(error)}


def _processor() -> dict[str, Any]:
    says: dict[str, str] = {}  # of the first core
    listed = Path("/proc/cpuinfo")
    for line in listed.read_text().split("\n\n")[0].splitlines() if listed.is_file() else ():
        name, _, value = line.partition(":")
        says[name.strip()] = value.strip()
    model = says.get("model name") or platform.processor() or platform.machine()
    return {"model": model, "cores": cores(), "instructions": _instructions(says)}


def _instructions(says: dict[str, str]) -> str:
    """Which of its variants (core/support/processor.h) the core takes; only Linux lets it choose."""
    if platform.machine().lower() in ("aarch64", "arm64"):
        return "NEON"
    flags = says.get("flags", "").split()
    skylake = (says.get("vendor_id"), says.get("cpu family"), says.get("model")) == ("GenuineIntel", "6", "85")
    if skylake and "avx512f" in flags and "avx512_vnni" not in flags:
        return "AVX-512"
    return "AVX2" if "avx2" in flags else "SSE2"
