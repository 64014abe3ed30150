"""Smooth curves over a surface: a closed spline through points, a B-spline near them; writes a picture.

Usage: python samples/splines.py [MESH]      (needs samples/setup.sh once; writes samples/out/splines.png)
"""

import mesh_input
import picture
import vorogeo

mesh_set = mesh_input.load_from_command_line()
mesh = mesh_set.current_mesh()
vertices, faces = mesh.vertex_matrix(), mesh.face_matrix()
surface = vorogeo.Surface(vertices, faces)
star = mesh_input.star_on(surface)
through = surface.spline(star, closed=True)
print(f"{surface.last.seconds:.2f} s for a spline of length {through.length:.5g}")
near = surface.b_spline(star, closed=True)
print(f"{surface.last.seconds:.2f} s for a B-spline of length {near.length:.5g}")
arch = surface.bezier(star[[6, 7, 9, 0]])
print(f"{surface.last.seconds:.2f} s for a Bezier curve of length {arch.length:.5g}")
picture.draw(
    "samples/out/splines.png",
    vertices,
    faces,
    lines=picture.joined(through.points, near.points, arch.points),
    points=star.positions(vertices, faces),
)
