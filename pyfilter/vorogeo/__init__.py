"""VoroGeo: geodesic distances on triangle meshes, for numpy and PyMeshLab.

On numpy arrays: `Surface` answers at once and builds an index when that pays. `GeodesicIndex` is built once per mesh
and then answers distances between vertices and distance fields; `estimate` says what that costs. `exact_distance_field`
needs no index, `distance_field` takes any of the `methods` of the literature; `check_mesh` reports what a mesh
contains. When PyMeshLab is installed, importing this package also loads the VoroGeo filters into it and binds them as
methods of ``pymeshlab.MeshSet``.
"""

from importlib.metadata import version as _version

from ._output import matrix_bytes
from .errors import Cancelled, Error, FileError, IndexFileError, InvalidInput, NotEnoughMemory, PluginError
from .functions import estimate, exact_distance_field, exact_path
from .geodesic_methods import (
    GeodesicMethod,
    MethodClaims,
    MethodInfo,
    MethodOption,
    MethodWarning,
    distance_field,
    methods,
)
from .mesh_check import MeshFinding, MeshReport, check_mesh
from .mesh_files import read_mesh
from .metrics import (
    EdgeLengths,
    FaceCost,
    FaceTensor,
    MetricLengths,
    VertexCost,
    VertexTensor,
    curvature_tensor,
    slope_cost,
)
from .plugin import load_on_import as _load_on_import
from .plugin import load_plugin
from .points import EdgeCurve, SurfacePoints
from .results import (
    Answered,
    Disk,
    Extent,
    FarthestSamples,
    GeodesicPath,
    IndexEstimate,
    IndexStatistics,
    Isolines,
    Polylines,
    RelaxedPoints,
    SparseDistances,
    VoronoiRegions,
)
from .surface import GeodesicIndex, Surface

__version__ = _version("vorogeo")
__all__ = [
    "Answered",
    "Cancelled",
    "Disk",
    "EdgeCurve",
    "EdgeLengths",
    "Error",
    "Extent",
    "FaceCost",
    "FaceTensor",
    "FarthestSamples",
    "FileError",
    "GeodesicIndex",
    "GeodesicMethod",
    "GeodesicPath",
    "IndexEstimate",
    "IndexFileError",
    "IndexStatistics",
    "InvalidInput",
    "Isolines",
    "MeshFinding",
    "MeshReport",
    "MethodClaims",
    "MethodInfo",
    "MethodOption",
    "MethodWarning",
    "MetricLengths",
    "NotEnoughMemory",
    "PluginError",
    "Polylines",
    "RelaxedPoints",
    "SparseDistances",
    "Surface",
    "SurfacePoints",
    "VertexCost",
    "VertexTensor",
    "VoronoiRegions",
    "check_mesh",
    "curvature_tensor",
    "distance_field",
    "estimate",
    "exact_distance_field",
    "exact_path",
    "load_plugin",
    "matrix_bytes",
    "methods",
    "read_mesh",
    "slope_cost",
]

_load_on_import()
