"""Girths along a body, by tape measure and along the surface, the profile of a path, and a path through landmarks.

Usage: python samples/measuring.py [MESH]      (needs samples/setup.sh once; writes samples/out/measuring.png, its
profile as measuring.csv and measuring-profile.png)
"""

from pathlib import Path

import matplotlib
import mesh_input
import numpy as np
import picture
import vorogeo

matplotlib.use("agg")
import matplotlib.pyplot as plt

STATIONS = 9

mesh_set = mesh_input.load_from_command_line()
mesh = mesh_set.current_mesh()
vertices, faces = mesh.vertex_matrix(), mesh.face_matrix()
surface = vorogeo.Surface(vertices, faces)
end = int(surface.extent().ends[0])  # of the component with the most vertices, on which all is measured
surface = vorogeo.Surface(vertices, faces, mask=np.isfinite(surface.distance_field(end)))
out = Path(__file__).parent / "out"
out.mkdir(exist_ok=True)

# Along the shortest path between the two vertices that are farthest apart: what lies there as a table and as a plot.
spine = surface.path(*surface.extent().ends)
profile = surface.profile(spine, up=[0, 1, 0])
columns = ",".join(profile._fields)
np.savetxt(out / "measuring.csv", np.column_stack(profile), delimiter=",", header=columns, comments="")
figure, rows = plt.subplots(4, sharex=True, figsize=(8, 8))
for row, name in zip(rows, profile._fields[1:], strict=True):
    row.plot(profile.length, getattr(profile, name))
    row.set_ylabel(name)
rows[-1].set_xlabel("length along the path")
figure.savefig(out / "measuring-profile.png")
print(f"from end to end {spine.length:.4g}, heights from {profile.height.min():.4g} to {profile.height.max():.4g}")

# Girths at places along the body, each in the plane of the shortest section there.
print(f"{'along':>10} {'section':>10} {'tape':>10} {'loop':>10}")
lines = [spine]
for along in np.linspace(0, spine.length, STATIONS + 2)[1:-1]:
    nearest = int(np.abs(profile.length - along).argmin())
    try:
        girth = surface.girth(spine.surface_points[nearest])
    except vorogeo.InvalidInput as error:
        print(f"{along:10.4g} {error}")
        continue
    print(f"{along:10.4g} {girth.section.length:10.4g} {girth.tape.length:10.4g} {girth.loop.length:10.4g}")
    lines.append(girth.section)
    if girth.loop.length > 0:
        lines.append(girth.loop)

# A closed path through landmarks, in their order and back to the first.
landmarks = surface.sample_farthest(4, start=surface.extent().ends).vertices
tour = surface.path_through(landmarks, closed=True)
print(f"through {landmarks.tolist()} and back: {tour.length:.4g}, proven to be shortest: {tour.certified}")

rings = picture.joined(*(line.points for line in lines))
values = surface.distance_field(int(surface.extent().ends[0]))
picture.draw(out / "measuring.png", vertices, faces, values, lines=rings, points=spine.points[[0, -1]])
