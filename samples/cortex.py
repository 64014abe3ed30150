"""A cortex: parcels, the medial wall left out, distances from borders of parcels, neighbours within 10 mm.

Usage: python samples/cortex.py      (needs samples/setup.sh once; the surface comes with the package nilearn)
"""

from pathlib import Path

import nibabel
import nilearn
import numpy as np
import picture
import vorogeo
from vorogeo import brain


def border_lines(vertices: np.ndarray, faces: np.ndarray, labels: np.ndarray) -> vorogeo.Polylines:
    """Lines between labels: straight through a face from the middle of an edge; three labels meet in its centre."""
    begin, end = [], []
    for k in range(3):
        a, b, c = np.roll(faces, k, axis=1).T
        alone = (labels[a] != labels[b]) & (labels[a] != labels[c]) & (labels[b] == labels[c])
        three = (labels[a] != labels[b]) & (labels[a] != labels[c]) & (labels[b] != labels[c])
        begin += [(vertices[a] + vertices[b])[alone] / 2, (vertices[a] + vertices[b])[three] / 2]
        end += [(vertices[a] + vertices[c])[alone] / 2, (vertices[a] + vertices[b] + vertices[c])[three] / 3]
    points = np.concatenate(begin + end)
    return vorogeo.Polylines(points, np.arange(len(points)).reshape(2, -1).T)


folder = Path(nilearn.__file__).parent / "datasets" / "data" / "fsaverage5"
white, faces = vorogeo.read_mesh(folder / "white_left.gii.gz")
pial, _ = vorogeo.read_mesh(folder / "pial_left.gii.gz")
inflated, _ = vorogeo.read_mesh(folder / "infl_left.gii.gz")
middle = (white + pial) / 2

# The medial wall is where the cortex has no thickness; distances neither cross nor see it.
thickness = nibabel.load(folder / "thick_left.gii.gz").darrays[0].data
cortex = thickness > 0.5
index = vorogeo.GeodesicIndex(middle, faces, mask=cortex)
print(f"{cortex.sum()} of {len(cortex)} vertices belong to the cortex")

# Twenty parcels of much the same size; an annotation would come from brain.read_labels("lh.aparc.annot").
seeds = index.relax(index.sample_farthest(20).points, rounds=5).vertices
parcels = index.voronoi(seeds).vertex_region
distance = brain.border_distance(index, parcels)
print(f"no vertex is more than {distance[np.isfinite(distance)].max():.1f} mm from a border of parcels")

# Regrown from their inner parts, the parcels are nearly the same.
inner = np.where(distance > 5, parcels, -1)
regrown, _ = brain.nearest_label(index, inner, background=[-1])
used = parcels >= 0
print(f"{np.mean(regrown[used] == parcels[used]):.1%} of vertices are nearest to the inner part of their own parcel")

near = index.pairs_within(np.flatnonzero(cortex), 10.0, dtype="float32")
print(f"within 10 mm a vertex has {near.nnz / near.shape[0]:.0f} neighbours; the sparse matrix has {near.nnz} entries")

out = Path(__file__).parent / "out" / "cortex.png"
shown = np.where(cortex, distance, np.nan)  # the medial wall stays grey
borders = border_lines(inflated, faces[cortex[faces].all(axis=1)], parcels)
picture.draw(out, inflated, faces, values=shown, lines=borders)
