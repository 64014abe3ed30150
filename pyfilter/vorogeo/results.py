"""Statistics of an index, and the results of its tasks: plain numpy arrays, as PyVista and polyscope expect them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from .points import SurfacePoints


@dataclass(frozen=True)
class Polylines:
    """Lines on a surface as points and edges.

    Attributes
    ----------
    points : ndarray of float64, shape (p, 3)
        Positions; lines share their points from face to face.
    edges : ndarray of int32, shape (q, 2)
        Rows of `points` that are joined.
    """

    points: NDArray[np.float64]
    edges: NDArray[np.int32]

    @property
    def length(self) -> float:
        """Sum of the lengths of all edges."""
        ends = self.points[self.edges]
        return float(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).sum())

    def to_pyvista(self) -> Any:
        """The lines as a ``pyvista.PolyData``; needs PyVista."""
        import pyvista

        cells = np.insert(self.edges.astype(np.int64), 0, 2, axis=1).ravel()
        return pyvista.PolyData(self.points, lines=cells) if len(self.edges) else pyvista.PolyData()


@dataclass(frozen=True)
class Isolines(Polylines):
    """Lines of equal value of a field.

    Attributes
    ----------
    values : ndarray of float64, shape (p,)
        The level at each point.
    """

    values: NDArray[np.float64]


@dataclass(frozen=True)
class VoronoiRegions:
    """Geodesic Voronoi regions of k points; a region has the position of its point in the list as number; -1 is none.

    Attributes
    ----------
    vertex_region : ndarray of int32, shape (n,)
        The region of the nearest point, the first of equally near ones; -1 where none can be reached.
    distance : ndarray of float64, shape (n,)
        Of each vertex from its nearest point; infinity where there is none.
    face_region : ndarray of int32, shape (m,)
        The region at the centre of each face; -1 also for a face that is left out.
    area : ndarray of float64, shape (k,)
        Of each region; 0 for a point that repeats an earlier one.
    borders : Polylines
        Where the distances from two points are equal: straight across each face, three meeting in a point.
    border_regions : ndarray of int32, shape (q, 2)
        The two regions at each edge of the borders.
    """

    vertex_region: NDArray[np.int32]
    distance: NDArray[np.float64]
    face_region: NDArray[np.int32]
    area: NDArray[np.float64]
    borders: Polylines
    border_regions: NDArray[np.int32]


@dataclass(frozen=True)
class FarthestSamples:
    """A farthest point sampling.

    Attributes
    ----------
    vertices : ndarray of int32, shape (k,)
        The samples in order; -1 for a start that is not a vertex.
    radius : ndarray of float64, shape (k,)
        Distance of each from the previous ones; infinity for the first of a component.
    distance : ndarray of float64, shape (n,)
        Of every vertex from the nearest sample.
    covering_radius : float
        The greatest of these distances, without isolated vertices; infinity if a component has no sample.
    points : SurfacePoints, k points
        The samples as points on faces.
    """

    vertices: NDArray[np.int32]
    radius: NDArray[np.float64]
    distance: NDArray[np.float64]
    covering_radius: float
    points: SurfacePoints


@dataclass(frozen=True)
class Disk:
    """What lies within a radius of a point.

    Attributes
    ----------
    vertices : ndarray of int32, shape (k,)
        Ids, ascending.
    distances : ndarray of float64, shape (k,)
        Of each from the nearest source.
    faces : ndarray of int32, shape (j,)
        Faces with all three corners inside, ascending.
    """

    vertices: NDArray[np.int32]
    distances: NDArray[np.float64]
    faces: NDArray[np.int32]


@dataclass(frozen=True)
class Extent:
    """How far a component reaches, over its vertices; the bounds hold for the distances as computed.

    Attributes
    ----------
    diameter : (float, float)
        Lower and upper bound of the greatest distance of two vertices.
    ends : (int, int)
        Two vertices at the distance of the lower bound.
    radius : (float, float)
        Lower and upper bound of the least eccentricity.
    centre : int
        A vertex whose eccentricity is the upper bound.
    fields : int
        Distance fields that were computed.
    """

    diameter: tuple[float, float]
    ends: tuple[int, int]
    radius: tuple[float, float]
    centre: int
    fields: int


@dataclass(frozen=True)
class RelaxedPoints:
    """The result of a Lloyd relaxation.

    Attributes
    ----------
    vertices : ndarray of int32, shape (k,)
        The final vertex of each point, in the order given; -1 for a point that stayed inside a face.
    energy : ndarray of float64, shape (rounds + 1,)
        Integral over the surface of the squared distance from the nearest point, at the beginning and after each round.
    points : SurfacePoints, k points
        The final position of each point.
    """

    vertices: NDArray[np.int32]
    energy: NDArray[np.float64]
    points: SurfacePoints


@dataclass(frozen=True)
class IndexStatistics:
    """What an index holds and what it cost.

    Attributes
    ----------
    vertices, faces, components : int
        Size of the mesh; degenerate and repeated faces are not counted.
    bridges : int
        Triangles that bridge gaps.
    first_layer_patches, second_layer_patches : int
        Patches of the mesh in each layer.
    first_layer_border_vertices, second_layer_border_vertices : int
        Vertices shared by patches of each layer.
    form : str
        'tables' (fast) or 'graph' (small), depending on delta and the memory budget.
    arcs_before_pruning, arcs : int
        Arcs between border vertices; in the form of tables, all of them are kept.
    bytes : int
        Memory held by the index.
    mapped_bytes : int
        Those of them that lie in the file which the index was loaded from: memory that all processes share.
    seconds : float
        Build time; 0 for an index that was loaded.
    expected_fields : float
        Exact fields of the mesh in whose time the build was expected, if that is so much (over 200) that an
        index hardly pays; 0 otherwise, and for an index that was loaded.
    delta : float
        Average relative error that pruning was allowed to add.
    seed : int
        Seed of the random numbers that placed the patches.
    shortened_edges : int
        With a metric, edges that got the length of the other two sides of a face, which are shorter; 0 without.
    split_faces : int
        With a metric, faces that are measured in parts, since a side would be longer than the other two; 0 without.
    """

    vertices: int
    faces: int
    bridges: int
    components: int
    first_layer_patches: int
    second_layer_patches: int
    first_layer_border_vertices: int
    second_layer_border_vertices: int
    form: str
    arcs_before_pruning: int
    arcs: int
    bytes: int
    mapped_bytes: int
    seconds: float
    expected_fields: float
    delta: float
    seed: int
    shortened_edges: int = 0
    split_faces: int = 0


@dataclass(frozen=True)
class IndexEstimate:
    """What an index of a mesh would cost, and what it would save, on this machine with nothing else to do.

    Attributes
    ----------
    build_seconds : float
        Of the build, on the threads asked for.
    core_seconds : float
        The same as work of one core.
    bytes : int
        Memory that the index would hold.
    form : str
        'tables' or 'graph', as for `IndexStatistics`.
    field_seconds : float
        Of a field from the index.
    exact_field_seconds : float
        Of an exact field, without an index.
    """

    build_seconds: float
    core_seconds: float
    bytes: int
    form: str
    field_seconds: float
    exact_field_seconds: float


class Answered(NamedTuple):
    """What gave an answer.

    Attributes
    ----------
    by : str
        'index', 'exact' or 'quick'.
    seconds : float
        Of the answer, without the build of an index.
    index_seconds : float
        Of an index that was built for it; 0 if none was.
    remark : str
        What to know about the choice; empty if nothing.
    """

    by: str
    seconds: float
    index_seconds: float
    remark: str


class SparseDistances(NamedTuple):
    """A sparse matrix in compressed rows: row i holds the entries indptr[i] to indptr[i + 1].

    Attributes
    ----------
    data : ndarray of float64, shape (entries,)
        Distances.
    indices : ndarray of int32, shape (entries,)
        Columns, ascending within a row.
    indptr : ndarray of int64, shape (rows + 1,)
        Where the rows begin.
    shape : (int, int)
        Rows and columns.
    """

    data: NDArray[np.float64]
    indices: NDArray[np.int32]
    indptr: NDArray[np.int64]
    shape: tuple[int, int]


@dataclass(frozen=True, repr=False)
class GeodesicPath:
    """A shortest path over the surface.

    Attributes
    ----------
    points : ndarray of float64, shape (p, 3)
        From source to target; consecutive points lie on a common face. Shape (0, 3) if there is no path.
    length : float
        Sum of the distances of consecutive points; infinity if there is no path.
    vertices : ndarray of int32, shape (p,)
        The vertex of each point; -1 for a point on an edge or in a face.
    surface_points : SurfacePoints
        The same points on faces.
    certified : bool
        For exact paths: whether it is proven that none is shorter. False for refined paths.
    over_gap : ndarray of bool, shape (p,)
        Whether the step from a point to the next one runs over a gap (`gap` of `Surface`), so over no face. A
        point between the borders of a gap has face -1 in `surface_points`.
    """

    points: NDArray[np.float64]
    length: float
    vertices: NDArray[np.int32]
    surface_points: SurfacePoints
    certified: bool
    over_gap: NDArray[np.bool_]

    def __repr__(self) -> str:
        return f"GeodesicPath(length {self.length:g}, {len(self.points)} points, certified: {self.certified})"

    def to_pyvista(self) -> Any:
        """The path as a ``pyvista.PolyData`` with one line; needs PyVista."""
        import pyvista

        if not len(self.points):
            return pyvista.PolyData()
        return pyvista.PolyData(self.points, lines=np.r_[len(self.points), np.arange(len(self.points))])
