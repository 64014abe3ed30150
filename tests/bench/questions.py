"""What is asked of every method: sources, and pairs of vertices near and far from each other."""

from __future__ import annotations

import warnings
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_matrix
from scipy.sparse.csgraph import connected_components

import meshes

Ids = NDArray[np.int64]


def sources_of(mesh: meshes.Mesh, count: int) -> list[int]:
    """The same random vertices in every run."""
    return with_face(mesh, count, np.random.default_rng(0)).tolist()


def patches_of(mesh: meshes.Mesh, index_file: Path) -> NDArray[np.int32]:
    """Second-layer patch of each face in a saved index."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # the environment of the benchmarks has no filters for PyMeshLab
        from vorogeo import GeodesicIndex

    return GeodesicIndex.load(index_file, *mesh).face_patches(2)


class Neighbourhood:
    """Which vertices are near: in one second-layer patch of the index, or in two that touch."""

    def __init__(self, mesh: meshes.Mesh, patches: NDArray[np.int32]) -> None:
        vertices, faces = mesh
        used = patches >= 0
        rows, columns = faces[used].ravel(), np.repeat(patches[used], 3)
        shape = (len(vertices), int(patches.max()) + 1)
        self.patch_of = csr_matrix((np.ones(len(rows), bool), (rows, columns)), shape=shape)
        self.touching = (self.patch_of.T @ self.patch_of).astype(bool).tocsr()
        self.vertex_of = self.patch_of.T.tocsr()
        edges = np.vstack([faces[:, [0, 1]], faces[:, [1, 2]]])
        links = csr_matrix((np.ones(len(edges), bool), edges.T), shape=(len(vertices), len(vertices)))
        self.component = connected_components(links, directed=False)[1]

    def far_pairs(self, sources: Ids, targets: Ids) -> Ids:
        """Those of the pairs that are far and that a path joins, shape (k, 2)."""
        near = (self.patch_of[sources] @ self.touching).multiply(self.patch_of[targets]).sum(axis=1)
        keep = (np.asarray(near).ravel() == 0) & (self.component[sources] == self.component[targets])
        return np.column_stack([sources, targets])[keep]

    def near_pairs(self, sources: Ids, random: np.random.Generator) -> Ids:
        """For each source a vertex of a random patch near it, shape (k, 2)."""
        pairs = []
        for source in sources.tolist():
            patches = (self.patch_of[[source]] @ self.touching).indices
            target = int(random.choice(self.vertex_of[[random.choice(patches)]].indices))
            if target != source and self.component[source] == self.component[target]:
                pairs.append((source, target))
        return np.array(pairs, np.int64).reshape(-1, 2)


def with_face(mesh: meshes.Mesh, count: int, random: np.random.Generator) -> Ids:
    """Random vertices that have a face."""
    return random.choice(np.unique(mesh[1]), count).astype(np.int64)
