"""Distance of every vertex from two others, in PyMeshLab: quality and colour of the vertices.

Usage: python samples/distance_field.py [MESH]      (needs samples/setup.sh once)
"""

import mesh_input

mesh_set = mesh_input.load_from_command_line()
last = mesh_set.current_mesh().vertex_number() - 1

# Sources by vertex number: the field of the nearest of them, from an index, which is built for it.
mesh_set.compute_selection_by_condition_per_vertex(condselect=f"(vi == 0) || (vi == {last})")
result = mesh_set.compute_scalar_by_vorogeo_distance_from_selection_per_vertex(method="index")
distances = mesh_set.current_mesh().vertex_scalar_array()  # -1 where no path leads

print(f"index: {result['index_seconds']:.2f} s, field: {result['seconds']:.4f} s")
print(f"farthest vertex: {distances.argmax()}, at distance {distances.max():g}")
print(f"unreachable vertices: {result['unreachable_vertices']}")

# A third source is a question to the same index.
result = mesh_set.compute_scalar_by_vorogeo_distance_from_given_point_per_vertex(vertex_index=int(distances.argmax()))
print(f"the index was reused: {result['index_reused']}, field: {result['seconds']:.4f} s")
