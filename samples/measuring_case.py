"""A scanned figurine from landmarks to a table: its back line, girths, areas and parts, with pictures.

Usage: python samples/measuring_case.py      (needs samples/setup.sh once; writes samples/out/measuring_case.csv, the
profile of the back line and pictures). docs/measuring.md tells it, and does the same by filters and by the mouse.
"""

from __future__ import annotations

import csv
from pathlib import Path
from typing import NamedTuple

import mesh_input
import numpy as np
import picture
import vorogeo

#: The unit of the scan is a quarter of a metre.
CENTIMETRES = 25
#: Landmarks are vertices; the window shows their numbers.
BACK = {"muzzle": 1396, "crown": 3199, "nape": 14689, "back": 3159, "tail": 11866}
THIGH = [15927, 1081, 7700, 9010, 1523, 16056]
#: A vertex, and the normal of the plane.
NECK, EAR = (14689, [-0.5, 1.0, 0.5]), (15981, [1.0, 1.0, -0.75])
#: The middle of a repair, and how far around it the surface was retouched.
REPAIR, REACH = 3847, 2.0


class Case(NamedTuple):
    """What was measured, and the rows of the table: name, value, unit."""

    back: vorogeo.GeodesicPath
    profile: vorogeo.Profile
    neck: vorogeo.Girth
    ear: vorogeo.Girth
    thigh: vorogeo.GeodesicPolygon
    table: list[tuple[str, float, str]]


def measure(surface: vorogeo.Surface) -> Case:
    """All of it, in the unit of the surface."""
    back = surface.path_through(list(BACK.values()))
    profile = surface.profile(back, up=[0, 1, 0])
    neck, ear = surface.girth(*NECK), surface.girth(*EAR)
    thigh = surface.polygon(THIGH)
    table = [
        ("back line", back.length, "cm"),
        ("its highest point", float(profile.height.max()), "cm"),
        ("neck by tape", neck.tape.length, "cm"),
        ("neck by section", neck.section.length, "cm"),
        ("neck, tightest loop", neck.loop.length, "cm"),
        ("ear by tape", ear.tape.length, "cm"),
        ("ear by section", ear.section.length, "cm"),
        ("ear, tightest loop", ear.loop.length, "cm"),
        ("thigh", thigh.area, "cm2"),
        ("border of the thigh", thigh.perimeter, "cm"),
        ("retouched", surface.disk_area(REPAIR, REACH, method="exact"), "cm2"),
        ("ear beyond its loop", surface.area(inside=ear.loop).area, "cm2"),
    ]
    return Case(back, profile, neck, ear, thigh, table)


def draw(out: Path, surface: vorogeo.Surface, case: Case) -> None:
    """The lines on the figurine, its parts in colours, and the profile of the back line as a plot."""
    import matplotlib

    matplotlib.use("agg")
    import matplotlib.pyplot as plt

    lines = [case.back, case.neck.section, case.neck.loop, case.ear.section, case.ear.loop, *case.thigh.legs]
    drawn = picture.joined(*(line.points for line in lines))
    marks = surface.vertices[[*BACK.values(), *THIGH, REPAIR]]
    picture.draw(out / "measuring_case-lines.png", surface.vertices, surface.faces, lines=drawn, points=marks)

    # Cut along the border of the thigh and the loop of the ear, then at the distance of the repair.
    cut = surface.cut([*case.thigh.legs, case.ear.loop])
    whole = vorogeo.Surface(cut.vertices, cut.faces)
    repair = whole.cut_at_levels(whole.distance_field(REPAIR), [REACH])
    parts = np.where(repair.region == 0, cut.region.max() + 1, cut.region[repair.input_faces])
    picture.draw(out / "measuring_case-parts.png", repair.vertices, repair.faces, regions=parts)

    figure, rows = plt.subplots(2, sharex=True, figsize=(8, 5))
    for row, name, unit in zip(rows, ("height", "curvature"), ("cm", "1/cm"), strict=True):
        row.plot(case.profile.length, getattr(case.profile, name))
        row.set_ylabel(f"{name} ({unit})")
    rows[-1].set_xlabel("along the back line (cm)")
    figure.tight_layout()
    figure.savefig(out / "measuring_case-profile.png", dpi=120)


def main() -> None:
    """Measure, write the tables and draw."""
    mesh_set = mesh_input.load(mesh_input.BUNNY)
    mesh = mesh_set.current_mesh()
    surface = vorogeo.Surface(CENTIMETRES * mesh.vertex_matrix(), mesh.face_matrix())
    case = measure(surface)
    out = Path(__file__).parent / "out"
    out.mkdir(exist_ok=True)
    with (out / "measuring_case.csv").open("w", newline="") as file:
        csv.writer(file).writerows([("name", "value", "unit"), *case.table])
    columns = ",".join(case.profile._fields)
    profile = np.column_stack(case.profile)
    np.savetxt(out / "measuring_case-profile.csv", profile, delimiter=",", header=columns, comments="")
    for name, value, unit in case.table:
        print(f"{name:22}{value:10.4g} {unit}")
    draw(out, surface, case)


if __name__ == "__main__":
    main()
