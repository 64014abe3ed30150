"""Reads the mesh of a sample into PyMeshLab, or ends with a sentence that says why it cannot; and ten points on it."""

import sys
from pathlib import Path

import numpy as np
import pymeshlab
import vorogeo  # also adds the VoroGeo filters to MeshSet

#: The real mesh that the pymeshlab package carries.
BUNNY = Path(pymeshlab.__path__[0]) / "tests" / "sample_meshes" / "bunny.obj"


def load(file: str | Path) -> pymeshlab.MeshSet:
    """A MeshSet whose current layer is the triangle mesh in a file."""
    if not Path(file).is_file():
        sys.exit(f"There is no file {file}. Give a PLY, OBJ, STL, OFF, GLB or other mesh file.")
    mesh_set = pymeshlab.MeshSet()
    try:
        mesh_set.load_new_mesh(str(file))
    except pymeshlab.PyMeshLabException as error:
        reason = str(error).strip().splitlines()[-1].removeprefix("Error details: ")
        sys.exit(f"{file} cannot be read as a mesh ({reason}). Give a PLY, OBJ, STL, OFF, GLB or other mesh file.")
    mesh = mesh_set.current_mesh()
    if mesh.face_number() == 0:
        sys.exit(f"{file} has {mesh.vertex_number()} vertices but no face. Geodesic distances need a triangle mesh.")
    return mesh_set


def load_from_command_line() -> pymeshlab.MeshSet:
    """The mesh named by the first argument of the script, the bunny if there is none."""
    return load(sys.argv[1] if len(sys.argv) > 1 else BUNNY)


def star_on(surface: vorogeo.Surface) -> vorogeo.SurfacePoints:
    """Ten points as the corners of a star, by straight lines from its middle."""
    size = np.ptp(surface.vertices, axis=0)
    middle = surface.snap(surface.vertices.mean(axis=0) + size * [0.1, 0, 1])
    turn, radius = 2 * np.pi * np.arange(10) / 10, size.max() * np.where(np.arange(10) % 2, 0.12, 0.3)
    return surface.exp_map(middle, radius[:, None] * np.column_stack([np.cos(turn), np.sin(turn)]))
