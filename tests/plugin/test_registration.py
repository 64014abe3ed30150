"""The host knows every filter by name, with its parameters, help and masks."""

from __future__ import annotations

import filters
import pymeshlab
import pytest
from support import grid, mesh_set

IN_SPACE = (filters.COMPARISON, filters.METHOD_TABLE)  # MeshLab's own methods measure lengths in space
GAPS = {"gap", "bridge_folds"}
METRIC = {"metric", "slope_penalty", "steepest_grade", "curvature_weight"} | {
    *("uphill_cost", "downhill_cost", "wind_attribute", "own_speed")
}


@pytest.mark.parametrize("name", filters.FILTERS)
def test_filter_has_its_names_help_and_masks(name):
    assert name in pymeshlab.filter_list()
    parameters, changes = filters.FILTERS[name]
    of_metric = METRIC | ({"to"} & parameters)
    of_surface = GAPS if name in IN_SPACE else GAPS | of_metric
    shown_on_request = of_surface | ({"delta", "memory_budget", "threads", "seed"} if name == filters.INDEX else set())
    ms = mesh_set(*grid(2, 2))
    assert set(ms.filter_parameter_values(name)) == parameters | of_surface
    told = ms.apply_filter("probe_help", filter=name)
    assert told["changes"] == changes
    assert told["help_length"] > 500
    assert told["cites"]
    assert told["names_itself"]
    assert told["filter_class"] != 0
    assert not told["sends_to_docs"]  # an installed plugin has no such file
    assert told["advanced_parameters"] == len(shown_on_request)
    assert told["advanced_last"]
