"""A polygon of shortest paths, the bands around it, and the mesh cut along all of them, with areas.

Usage: python samples/areas.py [MESH]      (needs samples/setup.sh once)
"""

import sys
from pathlib import Path

import mesh_input
import numpy as np
import picture
import vorogeo

mesh_set = mesh_input.load_from_command_line()
mesh = mesh_set.current_mesh()
vertices, faces = mesh.vertex_matrix(), mesh.face_matrix()
surface = vorogeo.Surface(vertices, faces)
end = int(surface.extent().ends[0])  # of the component with the most vertices: all points are to lie on it
surface = vorogeo.Surface(vertices, faces, mask=np.isfinite(surface.distance_field(end)))

# Five landmarks around a point of the surface, at a fifth of its width in space.
size = np.ptp(vertices, axis=0).max()
middle = surface.snap(vertices.mean(axis=0) + np.array([0, 0, size])).positions(vertices, faces)[0]
turn = 2 * np.pi * np.arange(5) / 5
landmarks = surface.snap(middle + 0.2 * size * np.column_stack([np.cos(turn), np.sin(turn), np.zeros(5)]))
try:
    polygon = surface.polygon(landmarks)
except vorogeo.InvalidInput as error:
    sys.exit(f"No polygon in the middle of this mesh: {error}")
print(f"polygon: area {polygon.area:.4g}, perimeter {polygon.perimeter:.4g}, {len(polygon.vertices)} vertices inside")
print(f"angles in degrees: {np.degrees(polygon.angles).round(1)}; Gauss-Bonnet leaves {polygon.gauss_bonnet:.1g}")

# The mesh cut along the legs; the smaller part is the inside. Distances from the legs, inside and outside.
cut = surface.cut(polygon.legs)
inside = cut.region == np.bincount(cut.region).argmin()
along = vorogeo.Surface(cut.vertices, cut.faces)
legs = vorogeo.EdgeCurve(cut.edges)
width = 0.02 * size
band = along.band(legs, width)
print(f"within {width:.4g} of the legs: area {band.area:.4g}, its border {band.border_length:.4g}")

# Cut once more, into bands. Values of the vertices follow: heights, say.
bands = along.cut_at_levels(along.distance_field(legs), width * np.arange(1, 5))
heights = np.append(cut.vertices[:, 1], bands.points.positions(cut.vertices[:, [1]], cut.faces))
print(f"{len(faces)} faces became {len(cut.faces)}, then {len(bands.faces)}; heights to {heights.max():.4g}")

regions = np.where(inside[bands.input_faces], bands.region, 5 + bands.region)
lines = vorogeo.Polylines(cut.vertices, cut.edges)
out = Path(__file__).parent / "out" / "areas.png"
picture.draw(
    out,
    bands.vertices,
    bands.faces,
    regions=np.where(regions == 9, -1, regions),
    lines=lines,
    points=landmarks.positions(vertices, faces),
)
