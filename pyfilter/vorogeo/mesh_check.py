"""A report on what a mesh contains that a user should know before trusting distances on it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

from . import _arguments as check
from . import _core
from ._records import doc, documented
from .mesh_input import gap_limit
from .mesh_objects import arrays_of


@dataclass(frozen=True)
class MeshFinding:
    """One kind of finding: how many elements, and the first of them (-1 if there is none)."""

    count: int
    first: int


@documented
@dataclass(frozen=True)
class MeshReport:
    """What `check_mesh` found; elements by their row in the given arrays."""

    vertices: int = doc("Rows of the array.")
    faces: int = doc("Likewise.")
    non_finite_vertices: MeshFinding = doc("Refused by everything that computes distances.")
    faces_out_of_range: MeshFinding = doc("Likewise.")
    faces_with_repeated_vertex: MeshFinding = doc("Left out.")
    duplicate_faces: MeshFinding = doc("Likewise.")
    zero_area_faces: MeshFinding = doc("Crossed at no cost.")
    duplicate_vertices: MeshFinding = doc("At the position of an earlier vertex; they are not joined.")
    isolated_vertices: MeshFinding = doc("Without a face; unreachable.")
    non_manifold_edges: MeshFinding = doc("Paths may turn there into any of the faces.")
    non_manifold_vertices: MeshFinding = doc("Likewise.")
    inconsistent_edges: MeshFinding = doc("Between two faces of opposite orientation; they have no effect.")
    rounded_edges: MeshFinding = doc(
        "Edges of whose lengths the coordinates hold fewer than four digits; the first by a vertex at it."
    )
    outliers: MeshFinding = doc(
        "Vertices joined to the rest of their component only by edges longer than a hundred typical lengths."
    )
    outlier_ratio: float = doc("The shortest of these edges, in typical lengths; 0 without outliers.")
    first_non_manifold_edge: tuple[int, int] = doc("Its vertices, or (-1, -1).")
    t_junctions: MeshFinding = doc(
        "Vertices inside a border edge of a face to which they do not belong: gaps without width, which no path "
        "crosses."
    )
    first_t_junction_edge: tuple[int, int] = doc("The ends of the edge in which the first of them lies, or (-1, -1).")
    border_edges: int = doc("Edges with one face.")
    border_loops: int = doc("The closed loops that they form.")
    longest_border_loop: float = doc("Length of the longest of these loops.")
    components: int = doc("Connected parts that have a face.")
    component_vertices: tuple[int, ...] = doc("How many vertices each has; the largest first.")
    near_borders: MeshFinding = doc(
        "Border vertices close to a vertex of another border, or of another part of their own, to which no short path "
        "leads: nearer than a tenth of the border edges there, with no path along edges shorter than one and a half "
        "of these."
    )
    nearest_borders: tuple[int, int] = doc("The closest two vertices of these, or (-1, -1).")
    near_border_gaps: tuple[float, float] = doc(
        "The least and the greatest distance of such vertices from their nearest neighbour across the gap."
    )
    gap_to_join_all: float = doc(
        "A `gap` with which all components become one, mostly the least; 0 if they are one or their borders touch, "
        "infinity if no gap is enough."
    )
    joined_borders: int = doc("How many border loops have an edge that is no border once gaps up to `gap` are bridged.")
    components_after_bridging: int = doc("Connected parts that are left then.")
    mean_edge_length: float = doc("In the unit of the positions.")
    longest_edge_length: float = doc("Likewise.")
    usable: bool = doc("Whether distances can be computed on the mesh.")
    usable_by_index: bool = doc(
        "Whether an index can be built as well, memory permitting: it takes lengths between 1e-28 and 1e28, the exact "
        "solver between 1e-60 and 1e60."
    )
    sentences: tuple[str, ...] = doc(
        "One sentence for each finding that may surprise a user, naming its first element."
    )
    summary: str = doc("Sizes, components and borders in one sentence.")

    def __str__(self) -> str:
        return "\n".join((self.summary, *self.sentences))


def check_mesh(vertices: Any, faces: Any = None, gap: float = 0.0, bridge_folds: bool = False) -> MeshReport:
    """Report on a mesh; bad geometry and bad vertex ids are findings, not errors.

    Parameters
    ----------
    vertices : array_like, shape (n, 3), or a mesh
        Positions; may hold NaN and infinity. A mesh of another package, as for `mesh_arrays`, is the only argument.
    faces : array_like of int, shape (m, 3), or polygons
        Vertex ids of the triangles; may be out of range.
    gap, bridge_folds
        As for `Surface`: what bridging would join is reported, too.
    """
    vertices, faces = arrays_of(vertices, faces)
    found = _core.check_mesh(
        check.vertices(vertices, finite=False), check.unchecked_faces(faces), *gap_limit(gap, bridge_folds)
    )
    findings: dict[str, Any] = {name: MeshFinding(*value) for name, value in found.pop("findings").items()}
    return MeshReport(**findings, **found)
