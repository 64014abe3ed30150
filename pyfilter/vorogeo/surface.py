"""`Surface` answers at once, `GeodesicIndex` builds its index first, and functions ask a mesh that is not kept."""

from __future__ import annotations

import os
from typing import Any, ClassVar, Literal, TypeVar, overload

import numpy as np
from numpy.typing import ArrayLike, DTypeLike, NDArray

from . import _arguments as check
from . import points as point_lists
from .directions import Directions
from .means import Means
from .measuring import Measuring
from .mesh_input import MeshInput
from .metrics import Metric
from .points import Points
from .progress import ProgressFunction, reporter
from .results import Answered, GeodesicPath, IndexEstimate, IndexStatistics, pyvista_mesh
from .tasks import METHODS, Shared, Sources, paths_of

_Kind = TypeVar("_Kind", bound="Surface")


class Surface(Measuring, Means, Directions):
    """A triangle mesh for any number of questions: it reads the mesh once and chooses what answers.

    The first answers are exact, without an index. When they have taken as long as building one is estimated to take,
    the index is built and answers from then on; so the time of all answers together is at most about twice that of
    the better choice, however many questions come. `last` says what answered. May be used by several threads at once,
    and pickled, with the index that it has.

    Parameters
    ----------
    vertices : array_like, shape (n, 3), or a mesh
        Finite positions; any real type and layout. None is possible with the metric `EdgeLengths`. A mesh of another
        package, as for `mesh_arrays`, is the only argument: `Surface(mesh)`.
    faces : array_like of int, shape (m, 3), or polygons
        Vertex ids of the triangles, 0 to n - 1; or of quads or polygons, which `mesh_arrays` divides.
    threads : int, optional
        Threads of each answer and of the build of an index; None is one per core. What the index answers does not
        depend on it; exact fields may differ in their last digits. Reading the mesh takes all cores in any case.
    memory_budget : int, optional
        MiB that an index may take; None is 4096. It consists of tables if they fit, otherwise of a pruned graph, which
        is smaller and slower; `statistics.form` says which.
    mask : array_like of bool, shape (m,) or (n,), optional
        Which faces belong to the surface, or which vertices (then the faces all of whose vertices do; if there are as
        many faces as vertices, a mask is one of faces). Distances neither cross nor see the others; vertices
        without a face are unreachable. Results refer to all vertices and faces.
    metric : EdgeLengths, VertexCost, VertexTensor, FaceCost, FaceTensor or FaceRanders, optional
        What paths cost; None is their length in space. All distances, radii and areas are then in its unit.
    gap, bridge_folds : float and bool, optional
        Borders up to `gap` apart that face each other (`bridge_folds`: or do not), and vertices at equal positions, are
        joined in the mesh that is measured on. To cross a gap costs its width, with a metric times the dearer side.

    Attributes
    ----------
    last : Answered or None
        What gave the last answer.

    Raises
    ------
    InvalidInput
        (a ValueError) If an argument has a wrong shape, type or range, naming the element.
    Cancelled
        If a progress function returned False; nothing was changed then. All functions of the package raise both.

    Notes
    -----
    What questions and tasks have in common: points are vertex ids, 0 to n - 1, `SurfacePoints` from `snap`, whose
    weights are barycentric, or lists of both; one point goes with each of k. Distances are in the unit of the vertices
    or of the metric, and infinity where no path leads.

    `method` of each is "automatic", "index" (built at once if there is none), "exact", or, for fields, "quick": an
    error below a tenth of a percent in the mean, on large meshes in a third to a tenth of the time. "automatic" takes
    what is expected to be fastest: where each distance reaches only a small part of the surface, "exact" even if there
    is an index; for fields on more than two million vertices without an index, "quick". None is the default of the
    class: "automatic", of a `GeodesicIndex` "index".

    `progress` is called as ``progress(fraction, text)`` from this thread, with a fraction in [0, 1] that never
    decreases; a result of False cancels. True shows a tqdm bar.

    `dtype`, float64 or float32, is the type of the distances: float32 takes half the memory and rounds to 6e-8 of a
    distance. `max_bytes` is the memory that the result may take, None what is available; `NotEnoughMemory` (a
    MemoryError) says that it does not fit.

    Examples
    --------
    >>> surface = vorogeo.Surface(vertices, faces)
    >>> surface.path(0, surface.snap([0.1, 0.2, 0.3])).length
    >>> surface.last.by
    'exact'
    """

    def __init__(
        self,
        vertices: Any,
        faces: Any = None,
        threads: int | None = None,
        memory_budget: int | None = None,
        mask: ArrayLike | None = None,
        metric: Metric | None = None,
        gap: float = 0.0,
        bridge_folds: bool = False,
    ) -> None:
        given = MeshInput.read(vertices, faces, mask, metric, gap, bridge_folds)
        workers, budget = check.threads(threads), check.memory_budget(memory_budget)
        self._hold(Shared(given, workers, budget, given.core_mesh().surface(workers, budget)))

    def _hold(self, shared: Shared) -> None:
        self._shared, self.last = shared, None

    @classmethod
    def of(cls: type[_Kind], shared: Shared) -> _Kind:
        """Another object that shares the same surface."""
        made = cls.__new__(cls)
        made._hold(shared)
        return made

    @property
    def index(self) -> GeodesicIndex | None:
        """The index, once there is one: the same surface, as a `GeodesicIndex`, which can be saved."""
        return GeodesicIndex.of(self._shared) if self._shared.core.has_index() else None

    def to_pyvista(self, **values: ArrayLike) -> Any:
        """The surface as a ``pyvista.PolyData``, with values of vertices or of faces by their names; needs PyVista.

        `surface.to_pyvista(distance=field).plot()` draws a field. Infinity becomes NaN, which is drawn without colour.
        """
        mesh = pyvista_mesh(self.vertices, self.faces)
        for name, value in values.items():
            array = check.numbers(name, value, "a number for each vertex or face")
            mesh[name] = np.where(np.isinf(array), np.nan, array) if array.dtype.kind == "f" else array
        return mesh

    def build_index(self, progress: ProgressFunction | bool | None = None) -> GeodesicIndex:
        """Build the index now, if there is none; errors are those of `GeodesicIndex`."""
        with reporter(progress) as report:
            self._shared.core.build_index(report)
        index = self.index
        assert index is not None
        return index

    @overload
    def distance_field(
        self,
        sources: Sources,
        max_distance: float | None = None,
        *,
        offsets: ArrayLike | None = None,
        return_labels: Literal[False] = False,
        to: bool = False,
        method: str | None = None,
        progress: ProgressFunction | bool | None = None,
        dtype: DTypeLike = np.float64,
    ) -> NDArray[Any]: ...
    @overload
    def distance_field(
        self,
        sources: Sources,
        max_distance: float | None = None,
        *,
        offsets: ArrayLike | None = None,
        return_labels: Literal[True],
        to: bool = False,
        method: str | None = None,
        progress: ProgressFunction | bool | None = None,
        dtype: DTypeLike = np.float64,
    ) -> tuple[NDArray[Any], NDArray[np.int32]]: ...
    def distance_field(
        self,
        sources: Sources,
        max_distance: float | None = None,
        *,
        offsets: ArrayLike | None = None,
        return_labels: bool = False,
        to: bool = False,
        method: str | None = None,
        progress: ProgressFunction | bool | None = None,
        dtype: DTypeLike = np.float64,
    ) -> NDArray[Any] | tuple[NDArray[Any], NDArray[np.int32]]:
        """Distance of every vertex from its nearest source.

        Parameters
        ----------
        sources : int, array_like of int of shape (k,), SurfacePoints, EdgeCurve, GeodesicPath, or a list of these
            At least one; repeated ones make no difference. A curve or a path is one source, replaced by points along
            it even in an exact field; those of a path are at most a quarter of the typical edge apart.
        max_distance : float, optional
            Distances above it become infinity; None for no limit.
        offsets : array_like, shape (k,), optional
            Lengths added to the distances from each source, finite and 0 or more; the least sum is taken.
        return_labels : bool, default False
            Whether to return also the nearest source.
        to : bool, default False
            Distances to the sources instead of from them, which only differ in a metric that goes one way.

        Returns
        -------
        distance : ndarray, shape (n,)
        label : ndarray of int32, shape (n,)
            Only if `return_labels`: the position of the nearest source in `sources`, -1 where there is none. Of sources
            at nearly the same distance, any of them.
        """
        limit, entry = check.max_distance(max_distance), check.real_type(dtype)
        rows, number = self._source_rows(sources)
        start = check.offsets(offsets, int(number[-1]) + 1)[number]
        found, label = self._ask(
            self._core(to).field, rows, start, limit, method=method, progress=progress, choices=METHODS
        )
        distance = found.astype(entry, copy=False)
        return (distance, np.where(label < 0, np.int32(-1), number[label])) if return_labels else distance

    def distance(
        self,
        source: Points,
        target: Points,
        method: str | None = None,
        progress: ProgressFunction | bool | None = None,
    ) -> Any:
        """Distance between two points, or between the points of each of k pairs.

        From an index, distances of vertices err by some hundredths of a percent; distances of other points are lengths
        of refined paths (`path`).

        The result, a float or ndarray of float64 of shape (k,), is symmetric, except in a metric that goes one way
        (`FaceRanders`).
        """
        count, core = len(self.vertices), self._shared.core
        # A single distance takes less time than the arrays that would carry it.
        if type(source) is int and type(target) is int and 0 <= source < count and 0 <= target < count:  # noqa: SIM102
            if METHODS[self._method(method)] != "exact" and core.has_index():
                distance, seconds = core.vertex_distance(source, target)
                self.last = Answered("index", seconds, 0.0, "")
                return distance
        ends = point_lists.pairs(("source", "target"), source, target, count)
        found = self._array(core.distances, *ends, method=method, progress=progress)
        return float(found[0]) if point_lists.is_single(source) and point_lists.is_single(target) else found

    def distances(
        self,
        sources: Points,
        targets: Points,
        progress: ProgressFunction | bool | None = None,
        method: str | None = None,
        dtype: DTypeLike = np.float64,
    ) -> NDArray[Any]:
        """Distances of k pairs of points, possibly none, on all threads: the values of `distance`, of shape (k,)."""
        entry = check.real_type(dtype)
        ends = point_lists.pairs(("sources", "targets"), sources, targets, len(self.vertices))
        found = self._array(self._shared.core.distances, *ends, method=method, progress=progress)
        return found.astype(entry, copy=False)

    def path(
        self,
        source: Points,
        target: Points,
        progress: ProgressFunction | bool | None = None,
        method: str | None = None,
    ) -> GeodesicPath | list[GeodesicPath]:
        """Shortest path between two points, or of each of k pairs: exact without an index, else the refined one.

        A refined path is the route of the index, shortened to a geodesic: never shorter than the shortest path, in most
        cases that path, and a few millionths longer in the mean.

        Returns
        -------
        GeodesicPath, or list of k GeodesicPath
            One path if both are single ids or hold one surface point each. Where no path joins them, the result
            has no points and infinite length.
        """
        return self._find_paths(source, target, False, False, method=method, progress=progress)

    def exact_path(
        self,
        source: Points,
        target: Points,
        certify: bool = True,
        progress: ProgressFunction | bool | None = None,
        method: str | None = None,
    ) -> GeodesicPath | list[GeodesicPath]:
        """Exact shortest path between two points, or of each of k pairs, without a field over the whole mesh.

        The index, where there is one, makes it faster. With it, a call that certifies 1,000 pairs or more first calls
        `prepare_exact_paths`, unless that was called before.

        Parameters
        ----------
        certify : bool, default True
            Whether to prove that no path is shorter, by lower bounds from straight lines in space and from what
            `prepare_exact_paths` computed. False: the distances of the index less an error margin serve as bounds,
            which is about twice as fast on large curved surfaces and hardly faster on others; on meshes of needles a
            few answers are then too long.

        Returns
        -------
        GeodesicPath, or list of k GeodesicPath
            `certified` says whether it is proven to be a shortest path.
        """
        return self._find_paths(source, target, True, bool(certify), method=method, progress=progress)

    def prepare_exact_paths(self, landmarks: int = 32, progress: ProgressFunction | bool | None = None) -> int:
        """Make all later certified paths faster, by exact distance fields from a few vertices.

        The differences of these distances are lower bounds of the distances of all pairs, on a curved surface much
        closer ones than straight lines in space. It pays off for many pairs: preparing takes as long as `landmarks`
        exact fields, and the build of the index if there is none. Returns the memory taken, in bytes: four for each
        vertex and landmark.

        Parameters
        ----------
        landmarks : int, default 32
            Number of vertices, 1 to 32, spread over the component with the most vertices.
        """
        count = check.integer("landmarks", landmarks, 1, 32)
        with reporter(progress) as report:
            return self._shared.core.use_landmarks(count, report)

    def _find_paths(
        self, source: Any, target: Any, exact: bool, certify: bool, **how: Any
    ) -> GeodesicPath | list[GeodesicPath]:
        ends = point_lists.pairs(("source", "target"), source, target, len(self.vertices))
        paths = paths_of(self._ask(self._shared.core.paths, *ends, exact, certify, **how))
        return paths[0] if point_lists.is_single(source) and point_lists.is_single(target) else paths

    def __repr__(self) -> str:
        held = "with an index" if self._shared.core.has_index() else "no index yet"
        return f"Surface({len(self.vertices)} vertices, {len(self.faces)} faces, {held})"


class GeodesicIndex(Surface):
    """Index of a triangle mesh for geodesic distances.

    A `Surface` that has its index from the beginning, and answers from it unless `method` says otherwise.
    Distances are lengths of shortest paths over the surface, in the unit of the vertices; infinity where no path
    exists. Long computations release the GIL. It works in processes that were forked, spawned, or started by a fork
    server.

    Parameters
    ----------
    vertices, faces, threads, mask, metric, gap, bridge_folds, progress
        As for `Surface` and its questions.
    patches : (int, int), optional
        Numbers of patches: of the mesh, and of smaller ones in each of these. 0 (None: both are 0) is chosen from n.
    delta : float, default 0
        Average relative error that pruning of the graph may add, in [0, 1). 0 loses nothing; a value above 0 selects
        the form of a graph.
    seed : int, default 0
        Seed of the random numbers that place the patches, 0 to 2**64 - 1.
    memory_budget : int, optional
        As for `Surface`; None is 4096, or no limit with `file`, whose tables are not counted.
    file : str or path, optional
        Where the index is built: its tables are written there as they are filled, and mapped, so that it may be larger
        than the memory. If the file has the index of this mesh, it is loaded; a build into it that was stopped, for
        whatever reason, is continued.

    Raises
    ------
    InvalidInput
        Also if the index does not fit the memory budget, naming the smallest budget that is enough.
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

    _default_method: ClassVar[str] = "index"

    def __init__(
        self,
        vertices: Any,
        faces: Any = None,
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
            core = given.core_mesh(report).surface_with_index(n1, n2, delta, workers, seed, budget, path, report)
        self._hold(Shared(given, workers, budget, core))

    @classmethod
    def load(
        cls,
        file: str | os.PathLike[str],
        vertices: Any,
        faces: Any = None,
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
        vertices, faces, mask, metric, gap, bridge_folds
            As for `Surface`, and the same as when the index was built: otherwise the file is refused.
        threads : int, optional
            Threads of each field; None is one per core.
        mapped : bool, default True
            Leave the large tables in the file: all processes that load it share that memory. It may be removed or
            replaced (`save` does so) while it is used, but not written to or truncated in place, which ends
            the process. False: copy them, for files that others may change.

        Raises
        ------
        IndexFileError
            (an OSError) If the file is missing, truncated, damaged, of another version or of another mesh.
        """
        path, workers = check.file_path(file), check.threads(threads)
        given = MeshInput.read(vertices, faces, mask, metric, gap, bridge_folds)
        return cls.of(Shared(given, workers, 0, given.core_mesh().load_index(path, workers, bool(mapped))))

    def save(self, file: str | os.PathLike[str]) -> None:
        """Write the index, without the mesh, to a file.

        An old file of this name stays until the new one is complete; a symbolic link is followed.

        Raises
        ------
        IndexFileError
            (an OSError) If it cannot be written: a full disk, no permission, a folder, a device or a pipe.
        """
        self._shared.core.save(check.file_path(file))

    def face_patches(self, layer: int) -> NDArray[np.int32]:
        """Patch of each face, numbered from 0, as int32 of shape (m,): large ones in layer 1, small ones in layer 2.

        -1 stands for a face that is left out: it is masked, names a vertex twice or repeats an earlier face.
        """
        return self._shared.core.face_patches(check.integer("layer", layer, 1, 2))

    @property
    def statistics(self) -> IndexStatistics:
        """What the index holds and what it cost."""
        lengths = self._shared.given.lengths
        of_metric = (0, 0) if lengths is None else (lengths.shortened_edges, lengths.split_faces)
        return IndexStatistics(**self._shared.core.statistics(), shortened_edges=of_metric[0], split_faces=of_metric[1])

    def __repr__(self) -> str:
        s = self.statistics
        return (
            f"GeodesicIndex({s.vertices} vertices, {s.faces} faces, patches ({s.first_layer_patches}, "
            f"{s.second_layer_patches}), {s.form}, delta {s.delta:g}, {s.bytes / 2**20:.1f} MiB)"
        )


def exact_distance_field(
    vertices: Any,
    faces: Any,
    sources: ArrayLike,
    max_distance: float | None = None,
    dtype: DTypeLike = np.float64,
    mask: ArrayLike | None = None,
    metric: Metric | None = None,
    gap: float = 0.0,
    bridge_folds: bool = False,
    threads: int | None = None,
    to: bool = False,
) -> NDArray[Any]:
    """Exact distance of every vertex from its nearest source: a `Surface` asked once, by the method "exact".

    Parameters
    ----------
    vertices, faces, mask, metric, gap, bridge_folds, threads, dtype
        As for `Surface`: shapes (n, 3) and (m, 3). With values of faces, distances are not exact but close, and one
        thread computes them.
    sources : int or array_like of int, shape (k,), k >= 1
        Vertex ids; repeated ones make no difference.
    max_distance : float, optional
        Distances above it are not computed and become infinity; None for no limit.
    to
        As for `Surface.distance_field`.

    Returns
    -------
    ndarray, shape (n,)
        Lengths of shortest paths over the surface, in the unit of the vertices or of the metric; infinity where there
        is none.

    Notes
    -----
    Exact propagation of windows (Mitchell, Mount, Papadimitriou 1987). Releases the GIL; Ctrl-C stops it.
    """
    surface = Surface(vertices, faces, threads, None, mask, metric, gap, bridge_folds)
    # Checked as ids, so that an error calls them what the caller gave.
    ids = check.source_ids(sources, len(surface.vertices))
    return surface.distance_field(ids, max_distance, to=to, method="exact", dtype=dtype)


def exact_path(
    vertices: Any,
    faces: Any,
    source: Points,
    target: Points,
    metric: Metric | None = None,
    mask: ArrayLike | None = None,
    progress: ProgressFunction | bool | None = None,
    gap: float = 0.0,
    bridge_folds: bool = False,
) -> GeodesicPath | list[GeodesicPath]:
    """Exact shortest path between two points, or of each of k pairs: a `Surface` asked once.

    Parameters
    ----------
    vertices, faces, mask, metric, gap, bridge_folds
        As for `Surface`: shapes (n, 3) and (m, 3). With values of faces, the edges that a path crosses are found by
        points on edges, and its crossings are then moved to where it is shortest.
    source, target, progress
        As for `Surface.path`.

    Returns
    -------
    GeodesicPath, or list of k GeodesicPath
        `certified` says whether it is proven exact: with values of faces only where no path leads or both ends are one.

    Notes
    -----
    Without values of faces, each path is found in a corridor of the mesh; where 100 pairs or more have one source, and
    with values of faces, by one propagation from each source, as far as its targets.
    """
    surface = Surface(vertices, faces, None, None, mask, metric, gap, bridge_folds)
    return surface.path(source, target, progress, method="exact")


def estimate(
    vertices: Any,
    faces: Any = None,
    threads: int | None = None,
    memory_budget: int | None = None,
    mask: ArrayLike | None = None,
    metric: Metric | None = None,
    progress: ProgressFunction | bool | None = None,
) -> IndexEstimate:
    """What an index would cost, from some of the work that its build does; takes a few percent of it.

    The result is right within a factor of about two. A mesh without a face is refused.

    Parameters
    ----------
    vertices, faces, threads, memory_budget, mask, metric, progress
        As for `Surface` and its questions: shapes (n, 3) and (m, 3).
    """
    given = MeshInput.read(vertices, faces, mask, metric)
    workers, budget = check.threads(threads), check.memory_budget(memory_budget)
    with reporter(progress) as report:
        return IndexEstimate(**given.core_mesh().estimate(workers, budget, report))
