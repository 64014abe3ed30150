"""A surface whose index is built at once: for options of the build, and to save and load it."""

from __future__ import annotations

import os
from typing import Any, ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _arguments as check
from . import _core
from .mesh_input import MeshInput
from .metrics import Metric
from .progress import ProgressFunction, reporter
from .results import IndexStatistics
from .surface import Surface


class GeodesicIndex(Surface):
    """Index of a triangle mesh for geodesic distances.

    A `Surface` that has its index from the beginning, and answers from it unless `method` says otherwise.
    Distances are lengths of shortest paths over the surface, in the unit of the vertices; infinity where no path
    exists. The index is immutable and may be used by several threads at once; long computations release the GIL. It
    can be pickled, and works in processes that were forked, spawned or served.

    Parameters
    ----------
    vertices : array_like, shape (n, 3)
        Finite positions; any real type and layout. None is possible with the metric `EdgeLengths`.
    faces : array_like of int, shape (m, 3)
        Vertex ids of the triangles, 0 to n - 1.
    patches : (int, int), optional
        Numbers of patches: of the mesh, and of smaller ones in each of these. 0 (None for both): chosen from n.
    delta : float, default 0
        Average relative error that pruning of the graph may add, in [0, 1). 0 loses nothing; a value above 0 selects
        the form of a graph.
    threads : int, optional
        Threads of the build and of each field; None is one per core. The results do not depend on it. Reading the
        mesh, the first percent of a build, takes all cores in any case.
    seed : int, default 0
        Seed of the random numbers that place the patches, 0 to 2**64 - 1.
    progress : callable or bool, optional
        Called as ``progress(fraction, text)`` from this thread, with a fraction in [0, 1] that never decreases; a
        result of False cancels. True shows a tqdm bar.
    memory_budget : int, optional
        MiB that the index may take; None is 4096, or any with `file`, whose tables are not counted. It consists of
        tables if they fit, otherwise of a pruned graph, which is smaller and slower; `statistics.form` says which.
    metric : EdgeLengths, VertexCost, VertexTensor, FaceCost or FaceTensor, optional
        What paths cost; None is their length in space. All distances, radii and areas are then in its unit.
    mask : array_like of bool, shape (m,) or (n,), optional
        Which faces belong to the surface, or which vertices (then the faces all of whose vertices do; if there are as
        many faces as vertices, a mask is one of faces). Distances neither cross nor see the others; vertices
        without a face are unreachable. Results refer to all vertices and faces.
    gap, bridge_folds : float and bool, optional
        Borders up to `gap` apart that face each other (`bridge_folds`: or do not), and equal positions, are joined in
        the mesh that is measured on (``docs/gaps.md``). Not together with a metric.
    file : str or path, optional
        Where the index is built (``docs/index-file.md``): its tables go there as they are filled and are mapped, so
        that it may be larger than the memory. If the file has the index of this mesh, it is loaded; if a build was
        stopped, by whatever, this one goes on where that was.

    Raises
    ------
    InvalidInput
        (a ValueError) If an argument has a wrong shape, type or range, naming the element, or if the index does
        not fit the memory budget, naming the smallest budget that is enough.
    Cancelled
        If `progress` returned False.
    MemoryError
        If the index does not fit into memory.
    IndexFileError
        (an OSError) If `file` cannot be written (a full disk is noticed before the long part), or belongs to another
        mesh or other options, or another process is writing it.

    Warns
    -----
    UserWarning
        Before a build that is expected to take more than a second and more than 200 exact fields of this mesh.

    Examples
    --------
    >>> index = vorogeo.GeodesicIndex(vertices, faces)
    >>> index.distance(0, 17)
    >>> index.distance_field([0, 17])
    """

    __slots__ = ()

    _default_method: ClassVar[str] = "index"

    def __init__(
        self,
        vertices: ArrayLike | None,
        faces: ArrayLike,
        patches: tuple[int, int] | None = None,
        delta: float = 0.0,
        threads: int | None = None,
        seed: int = 0,
        progress: ProgressFunction | bool | None = None,
        memory_budget: int | None = None,
        mask: ArrayLike | None = None,
        metric: Metric | None = None,
        gap: float = 0.0,
        bridge_folds: bool = False,
        file: str | os.PathLike[str] | None = None,
    ) -> None:
        given = MeshInput.read(vertices, faces, mask, metric, gap, bridge_folds)
        n1, n2 = check.patches(patches)
        delta, workers = check.delta(delta), check.threads(threads)
        seed = check.integer("seed", seed, 0, 2**64 - 1)
        budget = check.memory_budget(memory_budget)
        path = None if file is None else check.file_path(file)
        with reporter(progress) as report:
            handle = _core.Surface.build(
                *given.core_mesh, n1, n2, delta, workers, seed, budget, *given.gap, path, report
            )
        self._adopt(given, workers, budget, handle)

    @classmethod
    def load(
        cls,
        file: str | os.PathLike[str],
        vertices: ArrayLike | None,
        faces: ArrayLike,
        threads: int | None = None,
        mask: ArrayLike | None = None,
        metric: Metric | None = None,
        gap: float = 0.0,
        bridge_folds: bool = False,
        mapped: bool = True,
    ) -> GeodesicIndex:
        """Read an index that was saved for exactly this mesh.

        Parameters
        ----------
        file : str or path
            A file written by `save`.
        vertices : array_like, shape (n, 3)
            Positions of the mesh that the index was built for.
        faces : array_like of int, shape (m, 3)
            Its triangles.
        threads : int, optional
            Threads of each field; None is one per core.
        mask, metric, gap, bridge_folds
            Those that the index was built with: an index of others is refused.
        mapped : bool, default True
            Leave the large tables in the file: all processes that load it share that memory. It may be removed or
            replaced (`save` does so) while it is used, but not be written to or cut in place, which ends the
            process. False: copy them, for files that others may change.

        Raises
        ------
        IndexFileError
            (an OSError) If the file is missing, truncated, damaged, of another version or of another mesh.
        InvalidInput
            (a ValueError) If an argument has a wrong shape, type or range.
        """
        path, workers = check.file_path(file), check.threads(threads)
        given = MeshInput.read(vertices, faces, mask, metric, gap, bridge_folds)
        handle = _core.Surface.load(path, *given.core_mesh, workers, *given.gap, bool(mapped))
        index = cls.__new__(cls)
        index._adopt(given, workers, 0, handle)
        return index

    def __copy__(self) -> GeodesicIndex:
        return self  # immutable

    def __deepcopy__(self, memo: dict[int, Any]) -> GeodesicIndex:
        return self

    def save(self, file: str | os.PathLike[str]) -> None:
        """Write the index, without the mesh, to a file.

        An old file of this name stays until the new one is complete; a symbolic link is followed.

        Raises
        ------
        IndexFileError
            (an OSError) If it cannot be written: a full disk, no permission, a folder, a device or a pipe.
        """
        self._handle.save(check.file_path(file))

    def face_patches(self, layer: int) -> NDArray[np.int32]:
        """Patch of each face, numbered from 0.

        Parameters
        ----------
        layer : {1, 2}
            The large or the small patches.

        Returns
        -------
        ndarray of int32, shape (m,)
            -1 for a face that is left out (a vertex twice, or a repetition of an earlier face).

        Raises
        ------
        InvalidInput
            (a ValueError) For another layer.
        """
        return self._handle.face_patches(check.integer("layer", layer, 1, 2))

    @property
    def statistics(self) -> IndexStatistics:
        """What the index holds and what it cost."""
        lengths = self._input.lengths
        of_metric = (0, 0) if lengths is None else (lengths.shortened_edges, lengths.split_faces)
        return IndexStatistics(**self._handle.statistics(), shortened_edges=of_metric[0], split_faces=of_metric[1])

    def __repr__(self) -> str:
        s = self.statistics
        return (
            f"GeodesicIndex({s.vertices} vertices, {s.faces} faces, patches ({s.first_layer_patches}, "
            f"{s.second_layer_patches}), {s.form}, delta {s.delta:g}, {s.bytes / 2**20:.1f} MiB)"
        )
