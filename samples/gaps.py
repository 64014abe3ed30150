"""What bridging gaps does: a plate with a crack, and a rolled sheet that stays apart; or fields on a mesh of yours.

python samples/gaps.py [--picture FILE] [MESH GAP]
"""

from __future__ import annotations

import argparse
from pathlib import Path

import matplotlib
import numpy as np
import vorogeo

matplotlib.use("agg")
from matplotlib import pyplot


def sheet(columns: int, rows: int, width: float) -> tuple[np.ndarray, np.ndarray]:
    """A rectangle `width` x 1 of quads split in two."""
    x, y = np.meshgrid(np.linspace(0, width, columns + 1), np.linspace(0, 1, rows + 1))
    corner = (np.arange(rows)[:, None] * (columns + 1) + np.arange(columns)).ravel()
    lower = np.column_stack([corner, corner + 1, corner + columns + 2])
    upper = np.column_stack([corner, corner + columns + 2, corner + columns + 1])
    return np.column_stack([x.ravel(), y.ravel(), 0 * x.ravel()]), np.concatenate([lower, upper])


def cracked_plate() -> tuple[np.ndarray, np.ndarray]:
    """A plate 2 x 1 with a crack 0.02 wide through its middle, joined at one end only."""
    vertices, faces = sheet(16, 16, 0.99)
    other, more = sheet(16, 11, 0.99)
    joint = [[16, len(vertices), 33]]
    return np.vstack([vertices, other + np.array([1.01, 0, 0])]), np.vstack([faces, more + len(vertices), joint])


def roll() -> tuple[np.ndarray, np.ndarray]:
    """Two and a half turns of a sheet, 0.1 apart."""
    vertices, faces = sheet(100, 8, 2.5)
    angle, radius = 2 * np.pi * vertices[:, 0], 0.4 + 0.1 * vertices[:, 0]
    return np.column_stack([radius * np.cos(angle), radius * np.sin(angle), vertices[:, 1]]), faces


def panels(mesh: tuple[np.ndarray, np.ndarray], gap: float, source: int) -> list[tuple[str, np.ndarray]]:
    """Fields without and with bridges, and what there is to say about them."""
    fields = [vorogeo.exact_distance_field(*mesh, source, gap=g) for g in (0.0, gap)]
    changed = int((~np.isclose(fields[0], fields[1])).sum())
    said = [sentence for sentence in vorogeo.check_mesh(*mesh, gap=gap).sentences if sentence.startswith("Bridging")]
    print(*said, f"{changed} distances change.")
    return [("without", fields[0]), (f"gaps up to {gap:g} bridged", fields[1])]


def draw(
    axis: pyplot.Axes, mesh: tuple[np.ndarray, np.ndarray], field: np.ndarray, highest: float, title: str, zoom: float
) -> None:
    """Bands of distance on the surface, seen from above or obliquely; grey where no path leads."""
    vertices, faces = mesh
    shown = np.where(np.isfinite(field), field, -1.0)
    colors = pyplot.get_cmap("turbo_r")(np.floor(24 * np.clip(shown / highest, 0, 1))[faces].mean(axis=1) / 24)
    colors[shown[faces].min(axis=1) < 0] = 0.7
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection

    axis.add_collection3d(Poly3DCollection(vertices[faces], facecolors=colors, edgecolors="k", linewidths=0.15 / zoom))
    axis.set(xlim=np.ptp(vertices[:, 0]) * np.array([-0.0, 1]) + vertices[:, 0].min(), title=title)
    axis.set(
        ylim=(vertices[:, 1].min(), vertices[:, 1].max()), zlim=(vertices[:, 2].min(), vertices[:, 2].max() + 1e-9)
    )
    axis.set_box_aspect(np.ptp(vertices, axis=0) + 1e-3, zoom=zoom)
    axis.axis("off")


def main() -> None:
    """Reads the command line, and draws a row of fields for each mesh."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mesh", nargs="?", type=Path)
    parser.add_argument("gap", nargs="?", type=float)
    parser.add_argument("--picture", type=Path, default=Path("gaps.png"))
    given = parser.parse_args()
    if given.mesh is None:
        rows = [(cracked_plate(), 0.03, 16 * 17, (60, -90), 1.0), (roll(), 0.12, 0, (35, -60), 1.0)]
    else:
        rows = [(vorogeo.read_mesh(given.mesh), given.gap or 0.0, 0, (20, -60), 1.3)]
    figure = pyplot.figure(figsize=(5 * 2 * len(rows), 4.2))
    for row, (mesh, gap, source, view, zoom) in enumerate(rows):
        fields = panels(mesh, gap, source)
        highest = max(field[np.isfinite(field)].max() for _, field in fields)
        for column, (title, field) in enumerate(fields):
            axis = figure.add_subplot(1, 2 * len(rows), 2 * row + column + 1, projection="3d")
            axis.view_init(*view)
            draw(axis, mesh, field, highest, title, zoom)
    figure.tight_layout()
    figure.savefig(given.picture, dpi=100)
    print(f"wrote {given.picture}")


if __name__ == "__main__":
    main()
