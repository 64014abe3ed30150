"""All vertices in clusters around their means; writes a picture.

Usage: python samples/clusters.py [MESH]      (needs samples/setup.sh once; writes samples/out/clusters.png)
"""

import mesh_input
import picture
import vorogeo

mesh_set = mesh_input.load_from_command_line()
mesh = mesh_set.current_mesh()
vertices, faces = mesh.vertex_matrix(), mesh.face_matrix()
surface = vorogeo.Surface(vertices, faces)
clusters = surface.k_means(40)
print(
    f"{surface.last.seconds:.1f} s for 40 clusters in {len(clusters.energy) - 1} rounds; "
    f"the energy fell to {clusters.energy[-1] / clusters.energy[0]:.2f} of what it was"
)
picture.draw(
    "samples/out/clusters.png",
    vertices,
    faces,
    regions=clusters.labels[faces].max(axis=1),
    points=clusters.centres.positions(vertices, faces),
)
