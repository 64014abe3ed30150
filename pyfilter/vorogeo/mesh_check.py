"""A report on what a mesh contains that a user should know before trusting distances on it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from numpy.typing import ArrayLike

from . import _arguments as check
from . import _core
from .mesh_input import gap_limit


@dataclass(frozen=True)
class MeshFinding:
    """One kind of finding: how many elements, and the first of them (-1 if there is none)."""

    count: int
    first: int


@dataclass(frozen=True)
class MeshReport:
    """What `check_mesh` found; elements by their row in the given arrays.

    Attributes
    ----------
    vertices, faces : int
        Rows of the arrays.
    non_finite_vertices, faces_out_of_range : MeshFinding
        Refused by everything that computes distances.
    faces_with_repeated_vertex, duplicate_faces : MeshFinding
        Left out.
    zero_area_faces : MeshFinding
        Crossed at no cost.
    duplicate_vertices : MeshFinding
        At the position of an earlier vertex; they are not joined.
    isolated_vertices : MeshFinding
        Without a face; unreachable.
    non_manifold_edges, non_manifold_vertices : MeshFinding
        Paths may turn there into any of the faces.
    inconsistent_edges : MeshFinding
        Between two faces of opposite orientation; they have no effect.
    rounded_edges : MeshFinding
        Edges of whose lengths the coordinates hold fewer than four digits; the first by a vertex at it.
    outliers : MeshFinding
        Vertices joined to the rest of their component only by edges longer than a hundred typical lengths.
    outlier_ratio : float
        The shortest of these edges, in typical lengths; 0 without outliers.
    first_non_manifold_edge : (int, int)
        Its vertices, or (-1, -1).
    t_junctions : MeshFinding
        Vertices inside a border edge of a face to which they do not belong: gaps without width, which no path crosses.
    first_t_junction_edge : (int, int)
        The ends of the edge in which the first of them lies, or (-1, -1).
    border_edges, border_loops : int
        Edges with one face, and the closed loops that they form.
    longest_border_loop : float
        Length of the longest of these loops.
    components : int
        Connected parts that have a face.
    component_vertices : tuple of int
        How many vertices each has; the largest first.
    near_borders : MeshFinding
        Border vertices close to a vertex of another border, or of another part of their own, to which no short path
        leads: nearer than a tenth of the border edges there, with no path along edges shorter than one and a half of
        these.
    nearest_borders : (int, int)
        The closest two vertices of these, or (-1, -1).
    near_border_gaps : (float, float)
        The least and the greatest distance of such vertices from their nearest neighbour across the gap.
    gap_to_join_all : float
        The least `gap` with which all components become one; 0 if they are one or their borders touch, infinity if no
        gap is enough.
    joined_borders : int
        How many border loops have an edge that is no border once gaps up to `gap` are bridged.
    components_after_bridging : int
        Connected parts that are left then.
    mean_edge_length, longest_edge_length : float
    usable : bool
        Whether distances can be computed on the mesh.
    usable_by_index : bool
        Whether an index can be built as well, memory permitting: it takes lengths between 1e-28 and 1e28, the exact
        solver between 1e-60 and 1e60.
    sentences : tuple of str
        One sentence for each finding that may surprise a user, naming its first element.
    summary : str
        Sizes, components and borders in one sentence.
    """

    vertices: int
    faces: int
    non_finite_vertices: MeshFinding
    faces_out_of_range: MeshFinding
    faces_with_repeated_vertex: MeshFinding
    duplicate_faces: MeshFinding
    zero_area_faces: MeshFinding
    duplicate_vertices: MeshFinding
    isolated_vertices: MeshFinding
    non_manifold_edges: MeshFinding
    non_manifold_vertices: MeshFinding
    inconsistent_edges: MeshFinding
    rounded_edges: MeshFinding
    outliers: MeshFinding
    outlier_ratio: float
    first_non_manifold_edge: tuple[int, int]
    t_junctions: MeshFinding
    first_t_junction_edge: tuple[int, int]
    border_edges: int
    border_loops: int
    longest_border_loop: float
    components: int
    component_vertices: tuple[int, ...]
    near_borders: MeshFinding
    nearest_borders: tuple[int, int]
    near_border_gaps: tuple[float, float]
    gap_to_join_all: float
    joined_borders: int
    components_after_bridging: int
    mean_edge_length: float
    longest_edge_length: float
    usable: bool
    usable_by_index: bool
    sentences: tuple[str, ...]
    summary: str

    def __str__(self) -> str:
        return "\n".join((self.summary, *self.sentences))


def check_mesh(vertices: ArrayLike, faces: ArrayLike, gap: float = 0.0, bridge_folds: bool = False) -> MeshReport:
    """Report on a mesh; bad geometry and bad vertex ids are findings, not errors.

    Parameters
    ----------
    vertices : array_like, shape (n, 3)
        Positions; may hold NaN and infinity.
    faces : array_like of int, shape (m, 3)
        Vertex ids of the triangles; may be out of range.
    gap, bridge_folds
        As for `Surface`: what bridging would join is reported, too.
    """
    found = _core.check_mesh(
        check.vertices(vertices, finite=False), check.unchecked_faces(faces), *gap_limit(gap, bridge_folds)
    )
    findings: dict[str, Any] = {name: MeshFinding(*value) for name, value in found.pop("findings").items()}
    return MeshReport(**findings, **found)
