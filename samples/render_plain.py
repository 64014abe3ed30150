"""Plain pictures with matplotlib, for machines where VTK cannot draw."""

from __future__ import annotations

from pathlib import Path

import matplotlib
import numpy as np
from matplotlib.collections import PolyCollection
from panel import Panel

matplotlib.use("agg")
from matplotlib import pyplot

BANDS = 24


def draw(picture: Path, panels: list[Panel]) -> None:
    """Draw triangles from back to front, fields in bands of equal width."""
    figure, axes = pyplot.subplots(1, len(panels), figsize=(8 * len(panels), 7), squeeze=False)
    for axis, panel in zip(axes[0], panels, strict=True):
        depth, right, up = panel.view()
        corners = panel.vertices[panel.faces]
        normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        light = 0.4 + 0.6 * np.abs(normals @ depth) / np.maximum(np.linalg.norm(normals, axis=1), 1e-300)
        if panel.distance is not None:
            value = panel.distance[panel.faces].mean(axis=1) / (panel.distance.max() or 1.0)
            colors = pyplot.get_cmap("turbo_r")(np.clip(value, 0, 1))[:, :3]
            colors[panel.distance[panel.faces].min(axis=1) < 0] = 0.8
            colors[np.floor(value * BANDS) % 2 == 1] *= 0.75
        else:
            colors = panel.colors / 255.0
        order = np.argsort(corners.mean(axis=1) @ depth)
        flat = np.stack([corners @ right, corners @ up], axis=-1)[order]
        shaded = (colors * light[:, None])[order]
        axis.add_collection(PolyCollection(flat, facecolors=shaded, edgecolors=shaded, linewidths=0.3))
        axis.autoscale()
        axis.set_aspect("equal")
        axis.axis("off")
    figure.tight_layout()
    figure.savefig(picture, dpi=120)
