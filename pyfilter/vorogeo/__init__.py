"""VoroGeo: geodesic distances on triangle meshes, for numpy and PyMeshLab.

On numpy arrays: `Surface` answers at once and builds an index when that pays. `GeodesicIndex` is built once per mesh
and then answers distances between vertices and distance fields; `estimate` says what that costs. `exact_distance_field`
needs no index, `distance_field` takes any of the `methods` of the literature; `check_mesh` reports what a mesh
contains. When PyMeshLab is installed, importing this package also loads the VoroGeo filters into it and binds them as
methods of ``pymeshlab.MeshSet``.
"""

from importlib.metadata import version as _version
from types import ModuleType as _ModuleType

try:  # a binary that is missing or made for another system is reported in one sentence
    import numpy as _numpy  # noqa: F401

    from . import _core as _core
except ImportError as error:
    raise ImportError(
        f"vorogeo cannot be loaded: {error}; 'pip install --force-reinstall vorogeo' brings what fits this system."
    ) from None

from ._output import matrix_bytes as matrix_bytes
from .errors import Cancelled as Cancelled
from .errors import Error as Error
from .errors import FileError as FileError
from .errors import IndexFileError as IndexFileError
from .errors import InvalidInput as InvalidInput
from .errors import NotEnoughMemory as NotEnoughMemory
from .errors import PluginError as PluginError
from .geodesic_methods import GeodesicMethod as GeodesicMethod
from .geodesic_methods import MethodClaims as MethodClaims
from .geodesic_methods import MethodInfo as MethodInfo
from .geodesic_methods import MethodOption as MethodOption
from .geodesic_methods import MethodWarning as MethodWarning
from .geodesic_methods import distance_field as distance_field
from .geodesic_methods import methods as methods
from .mesh_check import MeshFinding as MeshFinding
from .mesh_check import MeshReport as MeshReport
from .mesh_check import check_mesh as check_mesh
from .mesh_files import read_mesh as read_mesh
from .mesh_objects import mesh_arrays as mesh_arrays
from .metrics import EdgeLengths as EdgeLengths
from .metrics import FaceCost as FaceCost
from .metrics import FaceRanders as FaceRanders
from .metrics import FaceTensor as FaceTensor
from .metrics import MetricLengths as MetricLengths
from .metrics import VertexCost as VertexCost
from .metrics import VertexTensor as VertexTensor
from .metrics import climbing_cost as climbing_cost
from .metrics import curvature_tensor as curvature_tensor
from .metrics import hiking_time as hiking_time
from .metrics import naismith as naismith
from .metrics import slope_cost as slope_cost
from .metrics import tobler as tobler
from .metrics import travel_time as travel_time
from .metrics import wheelchair as wheelchair
from .plugin import load_on_import as _load_on_import
from .plugin import load_plugin as load_plugin
from .points import EdgeCurve as EdgeCurve
from .points import SurfacePoints as SurfacePoints
from .results import Answered as Answered
from .results import Band as Band
from .results import Clusters as Clusters
from .results import CutLocus as CutLocus
from .results import CutMesh as CutMesh
from .results import Disk as Disk
from .results import DistanceGradient as DistanceGradient
from .results import Extent as Extent
from .results import FarthestSamples as FarthestSamples
from .results import GeodesicPath as GeodesicPath
from .results import GeodesicPolygon as GeodesicPolygon
from .results import Girth as Girth
from .results import IndexEstimate as IndexEstimate
from .results import IndexStatistics as IndexStatistics
from .results import Isolines as Isolines
from .results import MeshArrays as MeshArrays
from .results import Polylines as Polylines
from .results import Profile as Profile
from .results import RegionArea as RegionArea
from .results import RelaxedPoints as RelaxedPoints
from .results import SetDistances as SetDistances
from .results import SparseDistances as SparseDistances
from .results import TextureCoordinates as TextureCoordinates
from .results import VoronoiRegions as VoronoiRegions
from .surface import GeodesicIndex as GeodesicIndex
from .surface import Surface as Surface
from .surface import estimate as estimate
from .surface import exact_distance_field as exact_distance_field
from .surface import exact_path as exact_path

__version__ = _version("vorogeo")
#: What is imported here under its own name.
__all__ = [name for name, value in globals().items() if name[0] != "_" and not isinstance(value, _ModuleType)]

_load_on_import()
