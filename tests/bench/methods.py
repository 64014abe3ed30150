"""The methods that are measured: VoroGeo and public packages, all with the same interface.

A function for each method takes `vertices` (n, 3) and `faces` (m, 3), which is its set-up, and returns what answers:
`field(source)` gives the distances of all vertices, `pair(source, target)` that of two, by the best that the package
offers for it; both with numpy arrays.
"""

from __future__ import annotations

import importlib
import importlib.metadata
import os
import re
import sys
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

Field = NDArray[np.float64]
Faces = NDArray[np.int32]


class Method(NamedTuple):
    """What answers the questions; None where it has no answer."""

    field: Callable[[int], Field] | None
    pair: Callable[[int, int], float] | None = None
    index: Any = None  #: of VoroGeo


@dataclass(frozen=True)
class Description:
    """What the tables say about a method."""

    title: str
    package: str
    exact: bool = False
    fields: bool = True
    pairs: bool = False


#: In the order of the tables. `cgal_...` are measured by the program cgal_peer instead of a function here.
METHODS = {
    "vorogeo_index": Description("VoroGeo, index", "vorogeo", pairs=True),
    "vorogeo_exact": Description("VoroGeo, exact", "vorogeo", exact=True),
    "pygeodesic": Description("pygeodesic (MMP)", "pygeodesic", exact=True, pairs=True),
    "igl_exact": Description("libigl, exact (MMP)", "libigl", exact=True, pairs=True),
    "gdist": Description("gdist (MMP)", "gdist", exact=True, pairs=True),
    "cgal_exact": Description("CGAL, exact (Xin, Wang)", "CGAL", exact=True),
    "pp3d_heat": Description("potpourri3d, heat", "potpourri3d"),
    "pp3d_marching": Description("potpourri3d, fast marching", "potpourri3d"),
    "pp3d_flips": Description("potpourri3d, edge flips", "potpourri3d", fields=False, pairs=True),
    "igl_heat": Description("libigl, heat", "libigl"),
    "cgal_heat": Description("CGAL, heat", "CGAL"),
    "meshlab_point": Description("PyMeshLab, from a point", "pymeshlab"),
    "meshlab_heat": Description("PyMeshLab, heat", "pymeshlab"),
}


def description(name: str) -> Description:
    """Of one in the table, or of `our_NAME(OPTION=VALUE, ...)`, ours of docs/methods.md."""
    if name.startswith("our_"):
        return Description(f"VoroGeo, {name.removeprefix('our_')}", "vorogeo")
    return METHODS[name]


#: What is imported before the clock starts.
MODULES = {"vorogeo": "vorogeo", "libigl": "igl", "pygeodesic": "pygeodesic.geodesic"}


def import_package(name: str) -> None:
    """Import the package of a method, so that its set-up is the method's; an ImportError if it is not installed."""
    package = description(name).package
    if package == "vorogeo":
        sys.modules["pymeshlab"] = None  # type: ignore[assignment]  # its filters are not used: no time, no memory
    importlib.import_module(MODULES.get(package, package))


def make(name: str, vertices: Field, faces: Faces, threads: int, index_file: str | None) -> Method:
    """The method of a name, set up on a mesh; an ImportError if its package is not installed."""
    if name == "vorogeo_index":
        return vorogeo_index(vertices, faces, threads, index_file)
    if name.startswith("our_"):
        import vorogeo

        method, _, rest = name.removeprefix("our_").partition("(")
        options = {key: float(value) for key, value in re.findall(r"(\w+)=([^,)]+)", rest)}
        return Method(vorogeo.GeodesicMethod(vertices, faces, method, **options).distance_field)
    return globals()[name](vertices, faces)


def version(name: str) -> str:
    """Version of the package of a method."""
    return importlib.metadata.version(description(name).package)


def vorogeo_index(vertices: Field, faces: Faces, threads: int, index_file: str | None) -> Method:
    """Two points and fields from the index; read from `index_file` if that is given and there."""
    from vorogeo import GeodesicIndex

    if index_file and os.path.exists(index_file):
        index = GeodesicIndex.load(index_file, vertices, faces, threads=threads)
    else:
        index = GeodesicIndex(vertices, faces, threads=threads)
    return Method(index.distance_field, index.distance, index)


def vorogeo_exact(vertices: Field, faces: Faces) -> Method:
    """The exact solver; a call includes what it computes of the mesh, as for gdist and libigl."""
    from vorogeo import exact_distance_field

    return Method(lambda source: exact_distance_field(vertices, faces, source))


def pygeodesic(vertices: Field, faces: Faces) -> Method:
    """Danil Kirsanov's implementation of MMP."""
    from pygeodesic.geodesic import PyGeodesicAlgorithmExact

    solver = PyGeodesicAlgorithmExact(vertices, faces)
    return Method(
        lambda source: solver.geodesicDistances(np.array([source]), None)[0],
        lambda source, target: float(solver.geodesicDistance(source, target)[0]),
    )


def igl_exact(vertices: Field, faces: Faces) -> Method:
    """MMP of libigl."""
    import igl

    wide, everywhere = faces.astype(np.int64), np.arange(len(vertices))

    def run(source: int, targets: Any) -> Field:
        return igl.exact_geodesic(vertices, wide, np.array([source]), VT=targets)

    return Method(
        lambda source: run(source, everywhere), lambda source, target: float(run(source, np.array([target]))[0])
    )


def gdist(vertices: Field, faces: Faces) -> Method:
    """MMP of The Virtual Brain."""
    import gdist

    everywhere = np.arange(len(vertices), dtype=np.int32)

    def run(source: int, targets: Any) -> Field:
        return gdist.compute_gdist(vertices, faces, np.array([source], np.int32), np.asarray(targets, np.int32))

    return Method(lambda source: run(source, everywhere), lambda source, target: float(run(source, [target])[0]))


def pp3d_heat(vertices: Field, faces: Faces) -> Method:
    """Heat method of geometry-central, with its robust Laplacian."""
    import potpourri3d

    return Method(potpourri3d.MeshHeatMethodDistanceSolver(vertices, faces).compute_distance)


def pp3d_marching(vertices: Field, faces: Faces) -> Method:
    """Fast marching of geometry-central."""
    import potpourri3d

    solver = potpourri3d.MeshFastMarchingDistanceSolver(vertices, faces)
    return Method(lambda source: solver.compute_distance([[(source, [])]]))


def pp3d_flips(vertices: Field, faces: Faces) -> Method:
    """Locally shortest path by edge flips from a shortest path over edges."""
    import potpourri3d

    solver = potpourri3d.EdgeFlipGeodesicSolver(vertices, faces)

    def pair(source: int, target: int) -> float:
        path = solver.find_geodesic_path(source, target)
        return float(np.linalg.norm(np.diff(path, axis=0), axis=1).sum())

    return Method(None, pair)


def igl_heat(vertices: Field, faces: Faces) -> Method:
    """Heat method of libigl."""
    import igl

    data = igl.HeatGeodesicsData()
    igl.heat_geodesics_precompute(vertices, faces.astype(np.int64), data)
    return Method(lambda source: igl.heat_geodesics_solve(data, np.array([source])))


def meshlab_point(vertices: Field, faces: Faces) -> Method:
    """Built-in filter: fast marching from a point."""
    import pymeshlab

    mesh_set = meshlab_set(vertices, faces)
    # The filter stops at half the diagonal of the bounding box unless told otherwise.
    limit = pymeshlab.PureValue(1000 * mesh_set.current_mesh().bounding_box().diagonal())

    def field(source: int) -> Field:
        name = "compute_scalar_by_geodesic_distance_from_given_point_per_vertex"
        mesh_set.apply_filter(name, startpoint=vertices[source], maxdistance=limit)
        return mesh_set.current_mesh().vertex_scalar_array()

    return Method(field)


def meshlab_heat(vertices: Field, faces: Faces) -> Method:
    """Built-in filter: heat method from the selected vertex."""
    mesh_set = meshlab_set(vertices, faces)

    def field(source: int) -> Field:
        mesh_set.compute_selection_by_condition_per_vertex(condselect=f"(vi == {source})")
        mesh_set.apply_filter("compute_scalar_by_heat_geodesic_distance_from_selection_per_vertex")
        return mesh_set.current_mesh().vertex_scalar_array()

    field(0)  # the first call factors the matrices
    return Method(field)


def meshlab_set(vertices: Field, faces: Faces) -> Any:
    """A MeshSet with this mesh."""
    import pymeshlab

    mesh_set = pymeshlab.MeshSet()
    mesh_set.add_mesh(pymeshlab.Mesh(vertices, faces))
    return mesh_set
