"""The main job in PyMeshLab: a distance field and both layers of patches as PLY and PNG, and a table of figures.

Usage: python samples/quickstart.py MESH FOLDER
"""

import sys
from pathlib import Path

import mesh_input
import numpy as np
import pymeshlab
import render
import table


def front_point(mesh: pymeshlab.Mesh) -> np.ndarray:
    """Centre of the side of the bounding box that faces the camera: largest z, or least y if the mesh lies flat."""
    box = mesh.bounding_box()
    point = 0.5 * (box.min() + box.max())
    size = box.max() - box.min()
    if size[2] < 0.5 * min(size[0], size[1]):
        point[1] = box.min()[1]
    else:
        point[2] = box.max()[2]
    return point


def main() -> None:
    """Compute everything on the mesh given and write it to the folder given."""
    if len(sys.argv) != 3:
        sys.exit("usage: python samples/quickstart.py MESH FOLDER")
    mesh_file, out = Path(sys.argv[1]), Path(sys.argv[2])
    mesh_set = mesh_input.load(mesh_file)
    mesh = mesh_set.current_mesh()
    out.mkdir(parents=True, exist_ok=True)
    print(f"{mesh_file.name}: {mesh.vertex_number()} vertices, {mesh.face_number()} faces", flush=True)
    index_file = out / "index.vgi"
    built = mesh_set.compute_geodesic_index_by_vorogeo(index_file=str(index_file))

    field = mesh_set.compute_scalar_by_vorogeo_distance_from_given_point_per_vertex(start_point=front_point(mesh))
    start = (
        f"vertex {field['start_vertex']}" if field["start_vertex"] >= 0 else f"a point in face {field['start_face']}"
    )
    print(f"distances from {start}: up to {field['max_distance']:g}, in the unit of the mesh")
    if field["unreachable_vertices"]:
        print(f"no path leads to {field['unreachable_vertices']} vertices (quality -1, grey): see docs/mesh-policy.md")
    written = [out / "distance_field.ply"]
    mesh_set.save_current_mesh(str(written[0]), save_vertex_quality=True, save_vertex_color=True)
    for layer in (1, 2):
        patches = mesh_set.compute_color_by_vorogeo_patches_per_face(layer=layer)
        print(f"layer {layer}: {patches['patches']} patches")
        written.append(out / f"patches_layer_{layer}.ply")
        mesh_set.save_current_mesh(
            str(written[-1]), save_face_color=True, save_vertex_color=False, save_vertex_quality=False
        )
    for ply in written:
        render.draw(ply.with_suffix(".png"), [ply])
        print(f"written: {ply} and {ply.with_suffix('.png').name}", flush=True)

    table.print_table(mesh_file, mesh_set, built, index_file)


if __name__ == "__main__":
    main()
