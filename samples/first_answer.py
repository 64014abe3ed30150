"""Answers at once, and an index when it pays: estimate, exact field, path, quick field, and the change to an index.

Usage: python samples/first_answer.py [MESH]      (needs samples/setup.sh once)
"""

import mesh_input
import numpy as np
import vorogeo

mesh_set = mesh_input.load_from_command_line()
mesh = mesh_set.current_mesh()
vertices, faces = mesh.vertex_matrix(), mesh.face_matrix()

guess = vorogeo.estimate(vertices, faces)
print(f"an index would take {guess.build_seconds:.2g} s and {guess.bytes / 2**20:.2g} MiB, as long as", end=" ")
print(
    f"{guess.build_seconds / guess.exact_field_seconds:.0f} exact fields; a field from it {guess.field_seconds:.2g} s"
)

surface = vorogeo.Surface(vertices, faces)
exact = surface.distance_field(0)
print(f"field: {surface.last.by}, {surface.last.seconds:.3f} s")
path = surface.path(0, len(vertices) - 1)
print(f"path of length {path.length:g}: {surface.last.by}, {surface.last.seconds:.3f} s, certified: {path.certified}")
quick = surface.distance_field(0, method="quick")
reached = np.isfinite(exact) & (exact > 0)
error = np.abs(quick[reached] / exact[reached] - 1).mean()
print(f"field: {surface.last.by}, {surface.last.seconds:.3f} s, mean error {error:.2%}")

# Question after question: when exact answers have taken as long as an index, it is built.
for number, source in enumerate(np.random.default_rng(0).integers(0, len(vertices), 1000).tolist(), 1):
    surface.distance_field(source)
    if surface.last.by == "index":
        print(f"after {number} more fields an index was built in {surface.last.index_seconds:.2f} s: {surface.index}")
        break
