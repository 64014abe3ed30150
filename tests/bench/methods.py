"""The methods that are measured: VoroGeo and public packages, all with the same interface.

A method is made from `vertices` (n, 3) and `faces` (m, 3), which is its set-up. `field(source)` gives the distances of
all vertices, `pair(source, target)` that of two, by the best that the package offers for it; both with numpy arrays.
"""

from __future__ import annotations

import importlib
import importlib.metadata
import os
import sys
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Field = NDArray[np.float64]


@dataclass(frozen=True)
class Description:
    """What the tables say about a method."""

    title: str
    package: str
    exact: bool = False
    fields: bool = True
    pairs: bool = False


#: In the order of the tables. `cgal_...` are measured by the program cgal_peer instead of a class here.
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


#: What is imported before the clock starts.
MODULES = {"vorogeo": "vorogeo", "libigl": "igl", "pygeodesic": "pygeodesic.geodesic"}


def import_package(name: str) -> None:
    """Import the package of a method, so that its set-up is the method's; an ImportError if it is not installed."""
    package = METHODS[name].package
    if package == "vorogeo":
        sys.modules["pymeshlab"] = None  # type: ignore[assignment]  # its filters are not used: no time, no memory
    importlib.import_module(MODULES.get(package, package))


def make(name: str, vertices: Field, faces: NDArray[np.int32], threads: int, index_file: str | None) -> Any:
    """The method of a name, set up on a mesh; an ImportError if its package is not installed."""
    if name == "vorogeo_index":
        return VoroGeoIndex(vertices, faces, threads, index_file)
    return CLASSES[name](vertices, faces)


def version(name: str) -> str:
    """Version of the package of a method."""
    return importlib.metadata.version(METHODS[name].package)


class VoroGeoIndex:
    """Two points and fields from the index; read from `index_file` if that is given and there."""

    def __init__(self, vertices: Field, faces: NDArray[np.int32], threads: int, index_file: str | None) -> None:
        from vorogeo import GeodesicIndex

        if index_file and os.path.exists(index_file):
            self.index = GeodesicIndex.load(index_file, vertices, faces, threads=threads)
        else:
            self.index = GeodesicIndex(vertices, faces, threads=threads)

    def field(self, source: int) -> Field:
        return self.index.distance_field(source)

    def pair(self, source: int, target: int) -> float:
        return self.index.distance(source, target)


class VoroGeoExact:
    """The exact solver; a call includes what it computes of the mesh, as for gdist and libigl."""

    def __init__(self, vertices: Field, faces: NDArray[np.int32]) -> None:
        from vorogeo import exact_distance_field

        self.run, self.mesh = exact_distance_field, (vertices, faces)

    def field(self, source: int) -> Field:
        return self.run(*self.mesh, source)


class PyGeodesic:
    """Danil Kirsanov's implementation of MMP."""

    def __init__(self, vertices: Field, faces: NDArray[np.int32]) -> None:
        from pygeodesic.geodesic import PyGeodesicAlgorithmExact

        self.solver = PyGeodesicAlgorithmExact(vertices, faces)

    def field(self, source: int) -> Field:
        return self.solver.geodesicDistances(np.array([source]), None)[0]

    def pair(self, source: int, target: int) -> float:
        return float(self.solver.geodesicDistance(source, target)[0])


class LibiglExact:
    """MMP of libigl."""

    def __init__(self, vertices: Field, faces: NDArray[np.int32]) -> None:
        import igl

        self.run, self.vertices, self.faces = igl.exact_geodesic, vertices, faces.astype(np.int64)
        self.all = np.arange(len(vertices))

    def field(self, source: int) -> Field:
        return self.run(self.vertices, self.faces, np.array([source]), VT=self.all)

    def pair(self, source: int, target: int) -> float:
        return float(self.run(self.vertices, self.faces, np.array([source]), VT=np.array([target]))[0])


class Gdist:
    """MMP of The Virtual Brain."""

    def __init__(self, vertices: Field, faces: NDArray[np.int32]) -> None:
        import gdist

        self.run, self.mesh = gdist.compute_gdist, (vertices, faces.astype(np.int32))
        self.all = np.arange(len(vertices), dtype=np.int32)

    def field(self, source: int) -> Field:
        return self.run(*self.mesh, np.array([source], np.int32), self.all)

    def pair(self, source: int, target: int) -> float:
        return float(self.run(*self.mesh, np.array([source], np.int32), np.array([target], np.int32))[0])


class PotpourriHeat:
    """Heat method of geometry-central, with its robust Laplacian."""

    def __init__(self, vertices: Field, faces: NDArray[np.int32]) -> None:
        import potpourri3d

        self.solver = potpourri3d.MeshHeatMethodDistanceSolver(vertices, faces)

    def field(self, source: int) -> Field:
        return self.solver.compute_distance(source)


class PotpourriMarching:
    """Fast marching of geometry-central."""

    def __init__(self, vertices: Field, faces: NDArray[np.int32]) -> None:
        import potpourri3d

        self.solver = potpourri3d.MeshFastMarchingDistanceSolver(vertices, faces)

    def field(self, source: int) -> Field:
        return self.solver.compute_distance([[(source, [])]])


class PotpourriFlips:
    """Locally shortest path by edge flips from a shortest path over edges."""

    def __init__(self, vertices: Field, faces: NDArray[np.int32]) -> None:
        import potpourri3d

        self.solver = potpourri3d.EdgeFlipGeodesicSolver(vertices, faces)

    def pair(self, source: int, target: int) -> float:
        path = self.solver.find_geodesic_path(source, target)
        return float(np.linalg.norm(np.diff(path, axis=0), axis=1).sum())


class LibiglHeat:
    """Heat method of libigl."""

    def __init__(self, vertices: Field, faces: NDArray[np.int32]) -> None:
        import igl

        self.solve, self.data = igl.heat_geodesics_solve, igl.HeatGeodesicsData()
        igl.heat_geodesics_precompute(vertices, faces.astype(np.int64), self.data)

    def field(self, source: int) -> Field:
        return self.solve(self.data, np.array([source]))


class MeshLabPoint:
    """Built-in filter: fast marching from a point."""

    def __init__(self, vertices: Field, faces: NDArray[np.int32]) -> None:
        import pymeshlab

        self.set, self.vertices = pymeshlab.MeshSet(), vertices
        self.set.add_mesh(pymeshlab.Mesh(vertices, faces))
        # The filter stops at half the diagonal of the bounding box unless told otherwise.
        self.limit = pymeshlab.PureValue(1000 * self.set.current_mesh().bounding_box().diagonal())

    def field(self, source: int) -> Field:
        name = "compute_scalar_by_geodesic_distance_from_given_point_per_vertex"
        self.set.apply_filter(name, startpoint=self.vertices[source], maxdistance=self.limit)
        return self.set.current_mesh().vertex_scalar_array()


class MeshLabHeat:
    """Built-in filter: heat method from the selected vertex."""

    def __init__(self, vertices: Field, faces: NDArray[np.int32]) -> None:
        import pymeshlab

        self.set = pymeshlab.MeshSet()
        self.set.add_mesh(pymeshlab.Mesh(vertices, faces))
        self.field(0)  # the first call factors the matrices

    def field(self, source: int) -> Field:
        self.set.compute_selection_by_condition_per_vertex(condselect=f"(vi == {source})")
        self.set.apply_filter("compute_scalar_by_heat_geodesic_distance_from_selection_per_vertex")
        return self.set.current_mesh().vertex_scalar_array()


CLASSES = {
    "vorogeo_exact": VoroGeoExact,
    "pygeodesic": PyGeodesic,
    "igl_exact": LibiglExact,
    "gdist": Gdist,
    "pp3d_heat": PotpourriHeat,
    "pp3d_marching": PotpourriMarching,
    "pp3d_flips": PotpourriFlips,
    "igl_heat": LibiglHeat,
    "meshlab_point": MeshLabPoint,
    "meshlab_heat": MeshLabHeat,
}
