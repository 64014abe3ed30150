"""The surfaces of one run, made from its seed, and the pairs of answerer and surface that tests run on."""

from __future__ import annotations

import os
import secrets
from collections.abc import Iterable
from functools import cache
from typing import Any

import ask
import metric_surfaces
import numpy as np
import pytest
import surfaces
import vorogeo
from surfaces import Floats, Rng, Shape

#: A new one for every run; VOROGEO_CONTRACT_SEED repeats a run.
SEED = int(os.environ.get("VOROGEO_CONTRACT_SEED", secrets.randbits(32)))


@cache
def peer_field(bumpy: Shape, source: int) -> Floats:
    """Distances from a vertex by pygeodesic, an independent program."""
    geodesic = pytest.importorskip(
        "pygeodesic.geodesic", reason="pygeodesic, the independent program, is not installed"
    )
    return geodesic.PyGeodesicAlgorithmExact(bumpy.vertices, bumpy.faces).geodesicDistances(np.array([source]))[0]


def bumpy(random: Rng) -> Shape:
    """A wavy rectangle with shaken vertices, without a formula: another program gives its distances."""
    vertices, faces = surfaces.shaken_plane(random, 23, 17)
    a, b, c, d = random.uniform(2.0, 6.0, 4)
    x, y, _ = vertices.T
    vertices[:, 2] = 0.25 * np.sin(a * x + 1) * np.cos(b * y) + 0.1 * np.sin(c * x * y + d)

    def between(p: Floats, q: Floats) -> Floats:
        fields = np.array([peer_field(made, int(source)) for source in p[:, 0]])
        return fields[:, q[:, 0].astype(int)]

    ids = np.arange(len(vertices), dtype=float)[:, None]
    made = surfaces.shape("bumpy", (vertices, faces), between, chart=ids)
    return made


_random = np.random.default_rng(SEED)
_TILTS = np.where(np.arange(8) % 2 == 0, 0.5, -0.5)
LENGTHS = [
    surfaces.plane(_random),
    surfaces.needles(),
    surfaces.prism(),
    surfaces.cone("cone", np.full(8, -0.6)),
    surfaces.cone("saddle", _TILTS),
    surfaces.parts(),
    surfaces.repeats(_random),
    surfaces.hole(),
    surfaces.book(),
    bumpy(_random),
]
METRICS = metric_surfaces.metrics(_random, next(shape for shape in LENGTHS if shape.name == "saddle"))
SHAPES = [*LENGTHS, *METRICS]
#: Surfaces on which a way back costs something else: they have exact answers only, and some tasks refuse them.
DRIFTS = [
    metric_surfaces.drifting(shape, np.array([0.3, -0.4, 0.2]))
    for shape in SHAPES
    if shape.name in ("plane", "prism", "parts", "plane with one FaceTensor")
]
#: Surfaces on which the distance of any two vertices, and of points in faces, follows from a formula.
UNROLLED = [each for each in SHAPES if each.name not in ("half-plane", "shore", "bumpy")]


def named(name: str) -> Shape:
    """A surface of the table."""
    return next(each for each in SHAPES if each.name == name)


def asked(ways: Iterable[str], shapes: Iterable[Shape]) -> pytest.MarkDecorator:
    """Runs a test with each answerer on each surface on which it answers."""
    rows = [(by, shape) for shape in shapes for by in ways if ask.can_answer(by, shape)]
    return pytest.mark.parametrize(("by", "shape"), rows, ids=[f"{by}: {shape}" for by, shape in rows])


def points_anywhere(shape: Shape, random: Rng, count: int) -> vorogeo.SurfacePoints:
    """Points inside faces and on edges."""
    chosen = random.choice(np.flatnonzero(is_face(shape)), count)
    weights = random.dirichlet(np.ones(3), count)
    weights[::3, 0] = 0.0  # every third one on an edge
    return vorogeo.SurfacePoints(chosen.astype(np.int32), weights / weights.sum(axis=1, keepdims=True))


def is_face(shape: Shape) -> Any:
    """Which faces belong to the surface: not those that repeat an earlier face or name a vertex twice."""
    corners = np.sort(shape.faces, axis=1)
    first = np.zeros(len(corners), bool)
    first[np.unique(corners, axis=0, return_index=True)[1]] = True
    return first & (np.diff(corners, axis=1) > 0).all(axis=1)
