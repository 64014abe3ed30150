"""The case of docs/measuring.md has the same numbers by script and by filters."""

from __future__ import annotations

import sys

import filters
import numpy as np
import pytest
import vorogeo
from support import PROJECT, grid, layer_count, length, mesh_set

sys.path.insert(0, str(PROJECT / "samples"))
import measuring_case
import mesh_input


@pytest.fixture(scope="module")
def script():
    """What the script measures."""
    alive = mesh_set(*grid(1, 1))
    alive.apply_filter("set_selection_none")  # see support.load
    ms = mesh_input.load(mesh_input.BUNNY)
    mesh = ms.current_mesh()
    surface = vorogeo.Surface(measuring_case.CENTIMETRES * mesh.vertex_matrix(), mesh.face_matrix())
    return measuring_case.measure(surface)


def on_layer(ms, number, name, **parameters):
    """The filter, applied to this layer."""
    ms.set_current_mesh(number)
    return ms.apply_filter(name, **parameters)


@pytest.mark.parametrize("freeze", [False, True])
def test_filters_have_the_numbers_of_the_script(script, freeze):
    ms = mesh_input.load(mesh_input.BUNNY)
    ms.apply_filter(
        "compute_matrix_from_scaling_or_normalization",
        axisx=measuring_case.CENTIMETRES,
        uniformflag=True,
        freeze=freeze,
    )
    numbers = "; ".join(map(str, measuring_case.BACK.values()))
    found = {"back line": on_layer(ms, 0, filters.PATH_THROUGH, surface_points=numbers)["length"]}
    profile = on_layer(ms, 0, filters.PROFILE, curve_layer=layer_count(ms) - 1, up=np.array([0.0, 1.0, 0.0]))
    found["its highest point"] = profile["height"].max()
    for part in ("neck", "ear"):
        vertex, normal = getattr(measuring_case, part.upper())
        girth = on_layer(ms, 0, filters.GIRTH, vertex_index=vertex, normal=np.array(normal))
        found[f"{part} by tape"] = girth["tape_length"]
        found[f"{part} by section"] = girth["section_length"]
        found[f"{part}, tightest loop"] = girth["loop_length"]
    loop = layer_count(ms) - 2  # tape, loop and section are the new layers
    thigh = on_layer(ms, 0, filters.POLYGON, surface_points="; ".join(map(str, measuring_case.THIGH)))
    found["thigh"], found["border of the thigh"] = thigh["area"], thigh["perimeter"]
    disk = {"vertex_index": measuring_case.REPAIR, "radius": length(measuring_case.REACH), "exact": True}
    found["retouched"] = on_layer(ms, 0, filters.AREA, **disk)["area"]
    assert on_layer(ms, 0, filters.CUT_CURVE, curve_layer=loop)["parts"] == 2
    found["ear beyond its loop"] = on_layer(ms, 0, filters.REGION, curve_layer=loop)["area"]
    for name, value, _ in script.table:
        assert found[name] == pytest.approx(value, rel=1e-7), name
