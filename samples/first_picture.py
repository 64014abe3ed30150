"""A first picture: exact distances of all vertices from the first one, with isolines, by numpy alone.

Usage: python samples/first_picture.py [MESH]      (needs samples/setup.sh once, with --numpy or without)
"""

from pathlib import Path

import mesh_input
import picture
import vorogeo

mesh_set = mesh_input.load_from_command_line()
vertices, faces = vorogeo.mesh_arrays(mesh_set.current_mesh())
surface = vorogeo.Surface(vertices, faces)
field = surface.distance_field(0)
print(f"distances from vertex 0: up to {field[field < float('inf')].max():g}, in {surface.last.seconds:.2f} s")
out = Path(__file__).parent / "out" / "first_picture.png"
picture.draw(out, vertices, faces, values=field, lines=surface.isolines(field, 20), points=vertices[:1])
