"""Statistics of an index, and the results of its tasks: plain numpy arrays, as PyVista and polyscope expect them."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Annotated, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._records import doc, documented
from .points import SurfacePoints


def pyvista_mesh(vertices: Any, faces: Any) -> Any:
    """Triangles as a ``pyvista.PolyData``."""
    import pyvista

    return pyvista.PolyData.from_regular_faces(vertices, faces)


@documented
@dataclass(frozen=True)
class Polylines:
    """Lines on a surface as points and edges."""

    points: NDArray[np.float64] = doc("Shape (p, 3). Positions; lines share their points from face to face.")
    edges: NDArray[np.int32] = doc("Shape (q, 2). Rows of `points` that are joined.")

    @property
    def length(self) -> float:
        """Sum of the lengths of all edges."""
        ends = self.points[self.edges]
        return float(np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1).sum())

    def lines(self) -> list[NDArray[np.float64]]:
        """The positions along each line in order; a closed one ends where it begins. One that branches is refused.

        `surface.tighten(surface.snap(line))` pulls such a line tight.
        """
        return [self.points[line] for line in _core.lines_in_order(np.ascontiguousarray(self.edges, dtype=np.int32))]

    def to_pyvista(self) -> Any:
        """The lines as a ``pyvista.PolyData``; needs PyVista."""
        import pyvista

        cells = np.insert(self.edges.astype(np.int64), 0, 2, axis=1).ravel()
        return pyvista.PolyData(self.points, lines=cells) if len(self.edges) else pyvista.PolyData()


@documented
@dataclass(frozen=True)
class Isolines(Polylines):
    """Lines of equal value of a field."""

    values: NDArray[np.float64] = doc("Shape (p,). The level at each point.")


@documented
@dataclass(frozen=True)
class VoronoiRegions:
    """Geodesic Voronoi regions of k points; a region's number is the position of its point in the list, -1 for none."""

    vertex_region: NDArray[np.int32] = doc(
        "Shape (n,). The region of the nearest point, the first of equally near ones; -1 where none can be reached."
    )
    distance: NDArray[np.float64] = doc(
        "Shape (n,). Of each vertex from its nearest point; infinity where there is none."
    )
    face_region: NDArray[np.int32] = doc(
        "Shape (m,). The region at the centre of each face; -1 also for a face that is left out."
    )
    area: NDArray[np.float64] = doc("Shape (k,). Of each region; 0 for a point that repeats an earlier one.")
    borders: Polylines = doc(
        "Where the distances from two points are equal: straight across each face, three meeting in a point."
    )
    border_regions: NDArray[np.int32] = doc("Shape (q, 2). The two regions at each edge of the borders.")


@documented
@dataclass(frozen=True)
class FarthestSamples:
    """A farthest point sampling."""

    vertices: NDArray[np.int32] = doc("Shape (k,). The samples in order; -1 for a start that is not a vertex.")
    radius: NDArray[np.float64] = doc(
        "Shape (k,). Distance of each from the previous ones; infinity for the first of a component."
    )
    distance: NDArray[np.float64] = doc("Shape (n,). Of every vertex from the nearest sample.")
    covering_radius: float = doc(
        "The greatest of these distances, without isolated vertices; infinity if a component has no sample."
    )
    points: SurfacePoints = doc("k points. The samples as points on faces.")


@documented
@dataclass(frozen=True)
class Disk:
    """What lies within a radius of the nearest source."""

    vertices: NDArray[np.int32] = doc("Shape (k,). Ids, ascending.")
    distances: NDArray[np.float64] = doc("Shape (k,). Of each from the nearest source.")
    faces: NDArray[np.int32] = doc("Shape (j,). Faces with all three corners inside, ascending.")


@documented
@dataclass(frozen=True)
class Band:
    """What lies within a distance of points or curves."""

    area: float = doc("Of the faces inside and of the parts of those at the border.")
    border_length: float = doc("Of the line at the distance, without borders of the mesh.")


@documented
@dataclass(frozen=True)
class RegionArea:
    """The measures of a region."""

    area: float = doc("In the unit of the metric.")
    border_length: float = doc("Where faces are inside on one side only; borders of the surface count.")
    volume: float = doc("That it encloses in space, if it has no border; otherwise NaN. Cavities do not count.")


@documented
@dataclass(frozen=True)
class CutMesh:
    """A mesh cut along lines: parts of neighbouring faces share the points of the lines."""

    vertices: NDArray[np.float64] = doc("Shape (n + k, 3). The vertices of the surface, then the new ones.")
    faces: NDArray[np.int32] = doc(
        "Shape (j, 3). In the order of the faces of the surface; those that are left out of it are left out."
    )
    points: SurfacePoints = doc(
        "k points. Where on the surface the new vertices are: `points.positions(values, surface.faces)` interpolates "
        "any values of shape (n, d), such as colours."
    )
    input_faces: NDArray[np.int32] = doc("Shape (j,). The face of the surface that each is a part of.")
    region: NDArray[np.int32] = doc("Shape (j,). See `Surface.cut`.")
    edges: NDArray[np.int32] = doc("Shape (q, 2). Along the lines, in their direction; greater values to the left.")
    side: NDArray[np.int32] = doc(
        "Shape (j,). 1 to the left of a line, as most faces are turned, -1 to the right, 0 beside none or both."
    )

    def to_pyvista(self) -> Any:
        """The mesh as a ``pyvista.PolyData`` with the region of each face; needs PyVista."""
        mesh = pyvista_mesh(self.vertices, self.faces)
        mesh["region"] = self.region
        return mesh

    def part(self, region: int) -> tuple[NDArray[np.float64], NDArray[np.int32], NDArray[np.int32]]:
        """The vertices and faces of a region, and which vertices of the cut mesh its vertices are."""
        kept, faces = np.unique(self.faces[self.region == region], return_inverse=True)
        return self.vertices[kept], faces.reshape(-1, 3).astype(np.int32), kept


@documented
@dataclass(frozen=True)
class Extent:
    """How far a component reaches, over its vertices; the bounds hold for the distances as computed."""

    diameter: tuple[float, float] = doc("Lower and upper bound of the greatest distance of two vertices.")
    ends: tuple[int, int] = doc("Two vertices at the distance of the lower bound.")
    radius: tuple[float, float] = doc("Lower and upper bound of the least eccentricity.")
    centre: int = doc("A vertex whose eccentricity is the upper bound.")
    fields: int = doc("Distance fields that were computed.")


@documented
@dataclass(frozen=True)
class RelaxedPoints:
    """The result of a Lloyd relaxation."""

    vertices: NDArray[np.int32] = doc(
        "Shape (k,). The final vertex of each point, in the order given; -1 for a point that stayed inside a face."
    )
    energy: NDArray[np.float64] = doc(
        "Shape (rounds + 1,). Integral over the surface of the squared distance from the nearest point, at the "
        "beginning and after each round."
    )
    points: SurfacePoints = doc("k points. The final position of each point.")


@documented
@dataclass(frozen=True)
class Clusters:
    """Points or vertices divided into clusters around c centres."""

    labels: NDArray[np.int32] = doc("Shape (k,) or (n,). The nearest centre of each; -1 for a vertex without a face.")
    centres: SurfacePoints = doc("c points.")
    energy: NDArray[np.float64] = doc(
        "Shape (rounds + 1,). The weighted sum of squared distances from the nearest centre (k_medoids: of distances), "
        "at the beginning and after each round. It never rises, but by errors of an index."
    )


@documented
@dataclass(frozen=True)
class IndexStatistics:
    """What an index holds and what it cost."""

    vertices: int = doc("Size of the mesh.")
    faces: int = doc("Likewise; degenerate and repeated ones are not counted.")
    bridges: int = doc("Triangles that bridge gaps.")
    components: int = doc("Connected parts of the mesh.")
    first_layer_patches: int = doc("Patches of the mesh in this layer.")
    second_layer_patches: int = doc("Likewise.")
    first_layer_border_vertices: int = doc("Vertices shared by patches of this layer.")
    second_layer_border_vertices: int = doc("Likewise.")
    form: str = doc("'tables' (fast) or 'graph' (small), depending on delta and the memory budget.")
    arcs_before_pruning: int = doc("Arcs between border vertices.")
    arcs: int = doc("Those that are left; in the form of tables, all of them are.")
    bytes: int = doc("Memory held by the index.")
    mapped_bytes: int = doc(
        "Those of them that lie in the file which the index was loaded from: memory that all processes share."
    )
    seconds: float = doc("Build time; 0 for an index that was loaded.")
    expected_fields: float = doc(
        "Exact fields of the mesh in whose time the build was expected, if that is so much (over 200) that an index "
        "hardly pays; 0 otherwise, and for an index that was loaded."
    )
    delta: float = doc("Average relative error that pruning was allowed to add.")
    seed: int = doc("Seed of the random numbers that placed the patches.")
    shortened_edges: int = doc(
        "With a metric, edges that got the length of the other two sides of a face, which are shorter; 0 without.",
        default=0,
    )
    split_faces: int = doc(
        "With a metric, faces that are measured in parts, since it varies over them; 0 without.",
        default=0,
    )


@documented
@dataclass(frozen=True)
class IndexEstimate:
    """What an index of a mesh would cost, and what it would save, on this machine with nothing else to do."""

    build_seconds: float = doc("Of the build, on the threads asked for.")
    core_seconds: float = doc("The same as work of one core.")
    bytes: int = doc("Memory that the index would hold.")
    form: str = doc("'tables' or 'graph', as for `IndexStatistics`.")
    field_seconds: float = doc("Of a field from the index.")
    exact_field_seconds: float = doc("Of an exact field, without an index.")


@documented
class Answered(NamedTuple):
    """What gave an answer."""

    by: Annotated[str, "'index', 'exact' or 'quick'."]
    seconds: Annotated[float, "Of the answer, without the build of an index."]
    index_seconds: Annotated[float, "Of an index that was built for it; 0 if none was."]
    remark: Annotated[str, "What to know about the choice; empty if nothing."]
    expected_error: Annotated[
        float,
        "Of the distances of a field, relative, in the mean: of an exact one 0 but for rounding, or what is estimated "
        "where values of faces jump; of others a bound on the errors measured on many meshes with default patches. NaN "
        "where none is known: from an index where values of faces jump, and for what is not a field.",
    ] = math.nan
    unreached: Annotated[
        int, "Of a field, and of directions: vertices or targets to which no path leads, whatever the limit."
    ] = 0


@documented
class MeshArrays(NamedTuple):
    """A mesh as arrays: ``Surface(*mesh)``, or ``vertices, faces = mesh``."""

    vertices: Annotated[NDArray[np.float64], "Shape (n, 3). Positions, in the order of the file or of the mesh."]
    faces: Annotated[NDArray[np.int32], "Shape (m, 3). Vertex ids of the triangles."]


@documented
class SparseDistances(NamedTuple):
    """A sparse matrix in compressed rows: row i holds the entries indptr[i] to indptr[i + 1]."""

    data: Annotated[NDArray[np.float64], "Shape (entries,). Distances."]
    indices: Annotated[NDArray[np.int32], "Shape (entries,). Columns, ascending within a row."]
    indptr: Annotated[NDArray[np.int64], "Shape (rows + 1,). Where the rows begin."]
    shape: Annotated[tuple[int, int], "Rows and columns."]


@documented
@dataclass(frozen=True, repr=False)
class GeodesicPath:
    """A shortest path over the surface."""

    points: NDArray[np.float64] = doc(
        "Shape (p, 3). From source to target; consecutive points lie on a common face. Shape (0, 3) if there is no "
        "path."
    )
    length: float = doc("Sum of the distances of consecutive points; infinity if there is no path.")
    vertices: NDArray[np.int32] = doc("Shape (p,). The vertex of each point; -1 for a point on an edge or in a face.")
    surface_points: SurfacePoints = doc("The same points on faces.")
    certified: bool = doc("For exact paths: whether it is proven that none is shorter. False for refined paths.")
    over_gap: NDArray[np.bool_] = doc(
        "Shape (p,). Whether the step from a point to the next one runs over a gap (`gap` of `Surface`), so over no "
        "face. A point between the borders of a gap has face -1 in `surface_points`."
    )

    def __repr__(self) -> str:
        return f"GeodesicPath(length {self.length:g}, {len(self.points)} points, certified: {self.certified})"

    def to_pyvista(self) -> Any:
        """The path as a ``pyvista.PolyData`` with one line; needs PyVista."""
        import pyvista

        if not len(self.points):
            return pyvista.PolyData()
        return pyvista.PolyData(self.points, lines=np.r_[len(self.points), np.arange(len(self.points))])


@documented
@dataclass(frozen=True)
class Girth:
    """Three lengths round a limb; those of section and tape are in space, whatever the metric."""

    section: GeodesicPath = doc("Where the plane cuts the surface: from the point round to it.")
    tape: Polylines = doc("The convex hull of the section, as a tape measure lies.")
    loop: GeodesicPath = doc("The section pulled tight to a closed geodesic; a point of length 0 where it slips off.")
    normal: NDArray[np.float64] = doc("Shape (3,). Of the plane, of length 1.")


@documented
class Profile(NamedTuple):
    """What lies along a path, at each of its p points."""

    length: Annotated[NDArray[np.float64], "Shape (p,). Of the path up to the point."]
    height: Annotated[NDArray[np.float64], "Shape (p,). Of the point, in the direction `up`."]
    angle: Annotated[
        NDArray[np.float64],
        "Shape (p,). Of the normal with `up`, in radians: 0 on level ground turned upwards, pi if downwards.",
    ]
    curvature: Annotated[
        NDArray[np.float64],
        "Shape (p,). Of the surface in the direction of the path: 1 / r round a sphere whose normals lead outwards, "
        "below 0 in hollows.",
    ]
    thickness: Annotated[
        NDArray[np.float64],
        "Shape (p,). From the point against the normal to the next face; infinity if there is none.",
    ]


@documented
@dataclass(frozen=True)
class GeodesicPolygon:
    """A polygon of shortest paths and its inside: the side without border of the surface, else the smaller one."""

    area: float = doc("Of the inside.")
    perimeter: float = doc("Sum of the lengths of all legs.")
    corners: NDArray[np.int32] = doc("Shape (k,). Positions of its points in the list: of a hull those that span it.")
    angles: NDArray[np.float64] = doc("Shape (k,). Of the inside at each corner, in radians.")
    curvature: float = doc(
        "Sum of the angle defects of the vertices inside. The angles sum to (k - 2) pi and this, where the inside is a "
        "disk and no leg turns at a vertex."
    )
    gauss_bonnet: float = doc(
        "2 pi times the Euler characteristic of the inside, minus its curvature and the turning of its border at "
        "points and vertices: 0 but for rounding, where the metric does not jump and no edge has more than two faces."
    )
    vertices: NDArray[np.int32] = doc("Shape (p,). Inside, not on the border; ascending.")
    faces: NDArray[np.int32] = doc("Shape (j,). All of which are inside; ascending.")
    legs: list[GeodesicPath] = doc(
        "k paths: from each corner to the next, the last one to the first. `cut` takes them."
    )


@documented
@dataclass(frozen=True)
class SetDistances:
    """How far two sets of points are from each other; infinity where there is no path."""

    to_second: NDArray[np.float64] = doc("Shape (k,). Of each point of the first set from the nearest of the second.")
    to_first: NDArray[np.float64] = doc("Shape (j,). The other way.")
    nearest: float = doc("The least of them.")
    mean: float = doc("Of the means of both.")
    hausdorff: float = doc("The greatest of them: the Hausdorff distance along the surface.")


@documented
class DistanceGradient(NamedTuple):
    """Derivatives of the distances of k pairs by the positions of vertices; those that are not listed are 0."""

    distances: Annotated[NDArray[np.float64], "Shape (k,). Infinity where no path leads."]
    pairs: Annotated[NDArray[np.int32], "Shape (entries,). Which pair an entry belongs to, ascending."]
    vertices: Annotated[NDArray[np.int32], "Shape (entries,). Ascending within a pair."]
    values: Annotated[NDArray[np.float64], "Shape (entries, 3). Of the distance, by the position of the vertex."]


@documented
@dataclass(frozen=True)
class CutLocus(Polylines):
    """Where several shortest paths end, as lines."""

    distance: NDArray[np.float64] = doc("Shape (p,). Of each point from the nearest source.")
    angle: NDArray[np.float64] = doc(
        "Shape (p,). Between the directions in which shortest paths arrive there, in radians; at a vertex where a line "
        "begins, what its angles lack to a full turn."
    )
    surface_points: SurfacePoints = doc("p points. The same points on faces.")


@documented
class TextureCoordinates(NamedTuple):
    """Coordinates of a picture laid around a point."""

    uv: Annotated[NDArray[np.float64], "Shape (n, 2). (0.5, 0.5) at the point; NaN beyond the radius."]
    stretch: Annotated[
        NDArray[np.float64],
        "Shape (m, 2). The greatest and the least factor by which the picture is stretched in a face, beyond its "
        "scale: 1 and 1 where the surface is flat; NaN where a corner has no coordinates.",
    ]
