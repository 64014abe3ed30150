"""Loads the filter plugin that fits the installed PyMeshLab and binds its filters as MeshSet methods."""

from __future__ import annotations

import importlib
import importlib.util
import os
import platform
import re
import threading
import warnings
from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any

from ._arguments import file_path
from .errors import PluginError

FOLDER = Path(__file__).parent / "plugins"
FILE_NAME = "libfilter_vorogeo.so"
#: PyMeshLab releases whose filters this package supports, by the MeshLab version inside.
SUPPORTED = {"2022.02": "2022.2.post4", "2023.12": "2023.12.post3", "2025.07": "2025.7.post1"}

#: The names of our filters, and of no others, contain one of these.
_NAME_PARTS = ("vorogeo", "exact_geodesic_distance", "geodesic_method_comparison", "geodesic_method_table")
_NUMPY_PART = "The numpy functions of vorogeo work without it."
_lock = threading.Lock()
_loaded: tuple[str, ...] | None = None


def load_plugin(file: str | os.PathLike[str] | None = None) -> tuple[str, ...]:
    """Load the filters into PyMeshLab and bind them as methods of ``pymeshlab.MeshSet``.

    ``import vorogeo`` does this by itself when PyMeshLab is installed; call it to learn why it did not work, or to load
    a plugin that was built elsewhere. Filters of VoroGeo that PyMeshLab has already loaded are bound as they are. After
    the first success, further calls change nothing.

    Parameters
    ----------
    file : str or path, optional
        Plugin binary to load instead of the one in the package; it must be built for the installed PyMeshLab.

    Returns
    -------
    tuple of str
        Names of the filters.

    Raises
    ------
    PluginError
        (a RuntimeError) If PyMeshLab is missing, has a version without a plugin, or refuses the plugin.
    """
    global _loaded
    with _lock:
        if _loaded is None:
            pymeshlab = _import_pymeshlab()
            names = _our_filters(pymeshlab)  # there already if the user has called pymeshlab.load_plugin
            if not names:
                version = pymeshlab.pmeshlab.__version__
                others = set(_filters(pymeshlab))
                _load(pymeshlab, Path(file_path(file)) if file is not None else plugin_file(version))
                names = tuple(name for name in _filters(pymeshlab) if name not in others)
            for name in names:
                setattr(pymeshlab.MeshSet, name, _method(name))
            _loaded = names
        return _loaded


def plugin_file(pymeshlab_version: str) -> Path:
    """The plugin binary in this package for a PyMeshLab version such as '2025.7.post1'.

    If there is none, the message of the PluginError says what to do.
    """
    if platform.system() != "Linux":
        raise PluginError(
            f"The VoroGeo filters exist for PyMeshLab on Linux only, not on {platform.system()}. {_NUMPY_PART}"
        )
    host = meshlab_version(pymeshlab_version)
    if host not in SUPPORTED:
        *others, latest = SUPPORTED
        names = " or ".join(f"'pip install pymeshlab=={release}'" for release in reversed(SUPPORTED.values()))
        raise PluginError(
            f"PyMeshLab {pymeshlab_version} is installed, but the VoroGeo filters exist for MeshLab "
            f"{', '.join(others)} and {latest} only: run {names}. {_NUMPY_PART}"
        )
    file = FOLDER / host / FILE_NAME
    if not file.is_file():
        raise PluginError(
            f"This installation of vorogeo was built without its plugin for MeshLab {host}, which PyMeshLab "
            f"{pymeshlab_version} needs: run 'bash plugin/host/obtain_headers.sh {host}' in the VoroGeo project, do "
            f"what it says, and repeat 'pip install ./pyfilter'. {_NUMPY_PART}"
        )
    return file


def meshlab_version(pymeshlab_version: str) -> str | None:
    """MeshLab version inside a PyMeshLab release: '2025.07' for '2025.7.post1'; None if it is not a release."""
    match = re.fullmatch(r"(\d{4})\.0?(\d{1,2})(?:\.post\d+)?", pymeshlab_version)
    return f"{match[1]}.{int(match[2]):02d}" if match else None


def load_on_import() -> None:
    """What ``import vorogeo`` does: load the filters if PyMeshLab is there; a failure is a warning."""
    if platform.system() != "Linux" or importlib.util.find_spec("pymeshlab") is None:
        return
    try:
        load_plugin()
    except PluginError as error:
        warnings.warn(str(error), RuntimeWarning, stacklevel=3)


def _import_pymeshlab() -> ModuleType:
    if importlib.util.find_spec("pymeshlab") is None:
        raise PluginError(
            f"PyMeshLab is not installed: run 'pip install pymeshlab=={SUPPORTED['2025.07']}' to use the VoroGeo "
            f"filters. {_NUMPY_PART}"
        )
    try:
        return importlib.import_module("pymeshlab")
    except ImportError as error:
        raise PluginError(
            f"PyMeshLab is installed but cannot be imported ({error}); repair it to use the VoroGeo filters. "
            f"{_NUMPY_PART}"
        ) from error


def _our_filters(pymeshlab: ModuleType) -> tuple[str, ...]:
    """Names of the filters of VoroGeo among those that PyMeshLab has at the moment."""
    return tuple(name for name in _filters(pymeshlab) if any(part in name for part in _NAME_PARTS))


def _is_made_of_a_menu(name: str) -> bool:
    """Whether a name comes from a menu's text: PyMeshLab 2022.2 lists these as well, with our mark at the end."""
    return name.endswith("_vorogeo") and not name.endswith("_by_vorogeo")


def _filters(pymeshlab: ModuleType) -> list[str]:
    """Names of all filters that PyMeshLab has at the moment; none for old releases, which cannot list them."""
    filter_list: Callable[[], list[str]] = getattr(pymeshlab, "filter_list", list)
    return [name for name in filter_list() if not _is_made_of_a_menu(name)]


def _load(pymeshlab: ModuleType, binary: Path) -> None:
    if not binary.is_file():
        raise PluginError(f"There is no plugin file {binary}; give the path of a {FILE_NAME}.")
    try:
        pymeshlab.load_plugin(str(binary))
    except pymeshlab.PyMeshLabException as error:
        raise PluginError(
            f"PyMeshLab {pymeshlab.pmeshlab.__version__} refuses {binary}: {str(error).strip()} "
            "Repeat 'pip install ./pyfilter' in the VoroGeo project to rebuild it."
        ) from error


def _method(name: str) -> Callable[..., dict[str, Any] | None]:
    """A MeshSet method that applies a filter, as PyMeshLab makes them for its own plugins."""

    def filter_function(self: Any, **kwargs: Any) -> dict[str, Any] | None:
        result: dict[str, Any] = self.apply_filter(name, **kwargs)
        return result or None

    filter_function.__name__ = name
    filter_function.__qualname__ = f"MeshSet.{name}"
    return filter_function
