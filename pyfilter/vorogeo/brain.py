"""Brain surfaces: labels and masks from FreeSurfer and GIFTI files, distances to borders of labels, nearest labels."""

from __future__ import annotations

import os
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments as check
from .errors import FileError, InvalidInput
from .points import SurfacePoints
from .surface import Surface

#: Names of labels that are not cortex, in lower case without spaces and underscores.
OUTSIDE = frozenset(("???", "unknown", "medialwall", "corpuscallosum", "mask", "background"))


def _plain(name: str) -> str:
    return name.lower().replace("_", "").replace(" ", "")


@dataclass(frozen=True)
class Labels:
    """A label for each vertex.

    Attributes
    ----------
    values : ndarray of int32, shape (n,)
        The label of each vertex; from an annotation file a key of `names`, or -1 for no label.
    names : dict of int to str
        Names of labels, where the file has some.
    """

    values: NDArray[np.int32]
    names: dict[int, str]

    def mask(self, outside: str | Iterable[str] = OUTSIDE) -> NDArray[np.bool_]:
        """The vertices that belong to the surface: those whose label is not negative and has no name in `outside`.

        Without names, those whose label is not 0.

        Raises
        ------
        InvalidInput
            (a ValueError) If a name in `outside` is neither that of a label nor in `OUTSIDE`.
        """
        if not self.names:
            return np.not_equal(self.values, 0)
        given = [outside] if isinstance(outside, str) else list(outside)
        known = OUTSIDE | {_plain(name) for name in self.names.values()}
        for name in given:
            if _plain(name) not in known:
                raise InvalidInput(f"outside: no label is called {name!r}; give names of labels.")
        plain = {_plain(name) for name in given}
        left_out = [key for key, name in self.names.items() if _plain(name) in plain]
        return (self.values >= 0) & ~np.isin(self.values, left_out)


def read_labels(file: str | os.PathLike[str], vertex_count: int | None = None) -> Labels:
    """Labels of vertices from an annotation (.annot), a label (.label), GIFTI (.gii), or an array (.npy).

    Parameters
    ----------
    file : str or path
        A FreeSurfer .label lists the vertices of one label: these get 1, all others 0.
    vertex_count : int, optional
        Needed for .label files, which do not say how many vertices there are.

    Raises
    ------
    FileError
        (an OSError) If the file is missing or cannot be read.
    InvalidInput
        (a ValueError) If it holds no value for each vertex, or `vertex_count` is missing.
    """
    path = check.file_path(file)
    name = path.lower().removesuffix(".gz")
    if name.endswith(".label"):
        if vertex_count is None:
            raise InvalidInput(f"{path}: a .label file lists vertices only; give vertex_count.")
        ids = check.vertex_ids(path, _loaded(path, "read_label"), vertex_count)
        values = np.zeros(vertex_count, np.int32)
        values[ids] = 1
        return Labels(values, {})
    if name.endswith(".annot"):
        found, _, names = _loaded(path, "read_annot")
        return Labels(np.asarray(found, np.int32), {k: text.decode() for k, text in enumerate(names)})
    values, names_of = vertex_values(path)
    if values.dtype.kind == "f" and not (values == np.round(values)).all():
        raise InvalidInput(f"{path}: holds reals, no labels; give whole numbers.")
    return Labels(values.astype(np.int32), names_of)


def read_mask(file: str | os.PathLike[str], vertex_count: int | None = None) -> NDArray[np.bool_]:
    """Which vertices or faces belong to the surface, for `mask=`, from a file of labels or of values.

    Parameters
    ----------
    file : str or path
        An annotation or GIFTI labels: all but the medial wall and other labels with a name in `OUTSIDE`. A FreeSurfer
        .label, such as lh.cortex.label: its vertices. Values in GIFTI or .npy: all but 0 and NaN.
    vertex_count : int, optional
        Needed for .label files.

    Returns
    -------
    ndarray of bool, shape (n,)
        Shape (m,) for a .npy file with a value for each face. Errors are those of `read_labels`.
    """
    path = check.file_path(file)
    if path.lower().endswith((".label", ".annot")):
        return read_labels(path, vertex_count).mask()
    values, names = vertex_values(path)
    if names:
        return Labels(values.astype(np.int32), names).mask()
    kept: NDArray[np.bool_] = np.nan_to_num(values) != 0
    return kept


def _loaded(path: str, reader: str) -> Any:
    """What a function of nibabel reads."""
    try:
        import nibabel
        import nibabel.freesurfer
    except ImportError:
        raise ImportError(f"{path} is read by nibabel; run 'pip install nibabel'.") from None
    try:
        return nibabel.load(path) if reader == "load" else getattr(nibabel.freesurfer, reader)(path)
    except Exception as error:
        raise FileError(f"{path}: cannot be read ({' '.join(str(error).split())}).") from None


def vertex_values(path: str) -> tuple[NDArray[Any], dict[int, str]]:
    """One value for each vertex from GIFTI or .npy, and the names of GIFTI labels; errors as in `read_labels`."""
    names: dict[int, str] = {}
    if path.lower().endswith(".npy"):
        try:
            values = np.load(path, allow_pickle=False)
        except (OSError, ValueError) as error:
            raise FileError(f"{path}: cannot be read ({error}).") from None
    else:
        image = _loaded(path, "load")
        arrays = getattr(image, "darrays", [])
        if not arrays:
            raise InvalidInput(f"{path}: holds no values of vertices; give GIFTI, .annot, .label or .npy.")
        values = np.asarray(arrays[0].data)
        if image.get_arrays_from_intent("NIFTI_INTENT_LABEL"):
            names = {int(key): str(text) for key, text in image.labeltable.get_labels_as_dict().items()}
    if values.ndim != 1 or values.dtype.kind not in "biuf":
        raise InvalidInput(f"{path}: holds values of shape {values.shape}; give one for each vertex.")
    return values, names


def _checked(surface: Surface, labels: ArrayLike | Labels) -> NDArray[Any]:
    values: NDArray[Any] = np.asarray(labels.values if isinstance(labels, Labels) else labels)
    count = len(surface.vertices)
    if values.shape != (count,) or values.dtype.kind not in "biu":
        raise InvalidInput(
            f"labels: have shape {values.shape} and type {values.dtype}; give an integer for each of "
            f"the {count} vertices."
        )
    return values


def label_borders(surface: Surface, labels: ArrayLike | Labels, label: int | None = None) -> SurfacePoints:
    """Points along the borders between labels, at most a quarter of an edge from the next.

    A border crosses an edge between two labels at its midpoint and is straight inside a face; where a face has three
    labels, the three borders meet at its centre.

    Parameters
    ----------
    surface : Surface
        Or `GeodesicIndex`; masked faces have no border.
    labels : Labels or array_like of int, shape (n,)
    label : int, optional
        Only the borders of this label; None is all. A label that no vertex has is an error.
    """
    values = _checked(surface, labels)
    if label is not None:
        if label not in values:
            raise InvalidInput(f"label: no vertex has {label}; give a label that vertices have.")
        values = values == label
    corner = values[surface.faces]
    used = np.ones(len(corner), bool) if surface.mask is None else surface.mask
    differs = np.stack([corner[:, k] != corner[:, (k + 1) % 3] for k in range(3)], axis=1) & used[:, None]
    middle = np.array([[0.5, 0.5, 0.0], [0.0, 0.5, 0.5], [0.5, 0.0, 0.5]])
    faces, weights = [], []
    for alone in range(3):  # the corner with a label of its own: its two edges are crossed
        rows = np.flatnonzero(differs[:, alone] & differs[:, alone - 1] & ~differs[:, (alone + 1) % 3])
        ends = middle[alone], middle[alone - 1]
        for part in (0.0, 0.25, 0.5, 0.75, 1.0):
            faces.append(rows)
            weights.append(np.tile((1 - part) * ends[0] + part * ends[1], (len(rows), 1)))
    rows = np.flatnonzero(differs.all(axis=1))
    for edge in range(3):
        for part in (0.0, 0.5, 1.0) if edge == 0 else (0.0, 0.5):
            faces.append(rows)
            weights.append(np.tile((1 - part) * middle[edge] + part / 3, (len(rows), 1)))
    return SurfacePoints(np.concatenate(faces).astype(np.int32), np.concatenate(weights))


def border_distance(
    surface: Surface,
    labels: ArrayLike | Labels,
    label: int | None = None,
    max_distance: float | None = None,
    method: str | None = None,
) -> NDArray[np.float64]:
    """Distance of every vertex from the nearest border between labels (`label_borders`).

    Arguments are those of `label_borders` and of `Surface.distance_field`. The result, float64 of shape (n,), is too
    long by at most an eighth of an edge beside a border, far away by much less; infinity where no path leads to one.
    """
    points = label_borders(surface, labels, label)
    if not len(points):
        return np.full(len(surface.vertices), np.inf)
    return surface.distance_field(points, max_distance, method=method)


def nearest_label(
    surface: Surface,
    labels: ArrayLike | Labels,
    background: int | Iterable[int] = (-1, 0),
    max_distance: float | None = None,
    method: str | None = None,
) -> tuple[NDArray[np.int32], NDArray[np.float64]]:
    """The geodesic Voronoi regions of labels: for every vertex the label of the nearest labelled vertex.

    Parameters
    ----------
    surface, labels
        As for `label_borders`.
    background : int or iterable of int, default (-1, 0)
        Values that are no label; vertices with these values get the nearest label.
    max_distance, method
        As for `Surface.distance_field`.

    Returns
    -------
    label : ndarray of int32, shape (n,)
        -1 where no labelled vertex can be reached.
    distance : ndarray of float64, shape (n,)
        From that vertex; 0 for labelled vertices.

    Raises
    ------
    InvalidInput
        (a ValueError) Also if no vertex has a label.
    """
    values = _checked(surface, labels)
    left_out = np.array([background] if isinstance(background, (int, np.integer)) else list(background))
    labelled = np.flatnonzero(~np.isin(values, left_out))
    if not len(labelled):
        raise InvalidInput("labels: no vertex has a label that is not background.")
    distance, nearest = surface.distance_field(labelled, max_distance, return_labels=True, method=method)
    found = np.where(nearest < 0, -1, values[labelled][nearest]).astype(np.int32)
    found[labelled] = values[labelled]
    return found, distance
